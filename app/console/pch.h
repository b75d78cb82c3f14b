// Precompiled for the window.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <QtWidgets>
