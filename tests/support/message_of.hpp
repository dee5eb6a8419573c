// The message of what a call throws.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "footfall/errors.hpp"

namespace footfall::test {

/// The message of the InputError that `work` throws; "no error" when it throws nothing.
template <class Work>
std::string messageOf(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace footfall::test
