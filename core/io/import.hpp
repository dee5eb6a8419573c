// Reading environments from files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "footfall/io.hpp"

namespace footfall::detail {

/// load() with all parts of the file, shared: usual roles are not applied (applyPartRules()).
std::shared_ptr<const Environment> importEnvironment(const std::string& path, const ImportOptions& options = {},
                                                     RunContext* context = nullptr);

}  // namespace footfall::detail
