// Replaces sheet_pdf.cpp when libharu was not found.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/plan_sheet.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {

std::string formatSheetsPdf(std::span<const Sheet> /*sheets*/) {
  throw InputError(
      FOOTFALL_TEXT("this program was built without libharu and cannot write .pdf; install libhpdf-dev and build it "
                    "again, or draw the plan as .svg"));
}

}  // namespace footfall::detail
