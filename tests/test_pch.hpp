// Headers that nearly every suite includes, compiled once.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <QtTest>
#include <memory>
#include <string>
#include <vector>
