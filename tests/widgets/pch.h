// Precompiled for the window's tests.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <QtTest>
#include <QtWidgets>
