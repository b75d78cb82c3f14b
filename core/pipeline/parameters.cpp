#include "core/pipeline/parameters.h"

template std::vector<fyd::Parameter> fyd::bindParameters(fyd::pipeline::Parameters& instance);
