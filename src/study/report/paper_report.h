#pragma once

#include "study/report/paper_claims.h"
#include "study/report/report.h"

namespace multipath {

/// The report of the paper's reproduction: its statements beside what was found, then every table and figure, each with
/// how to read it.
Report paper_report(const PaperFindings& findings);

} // namespace multipath
