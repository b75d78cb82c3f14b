// FYD_API: what libfyd shows to other programs. Everything else of the library is hidden in it (-fvisibility=hidden).
// Stability: stable since 0.1
#pragma once

#define FYD_API __attribute__((visibility("default")))
