// Precompiled for the widgets: Qt and QCustomPlot are the bulk of every file there.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <QtWidgets>

#include <qcustomplot.h>
