#pragma once

#include "study/paper_findings.h"
#include "study/report.h"

namespace multipath {

/// The report of the paper's reproduction: its statements beside what was found, then every table and figure, each with
/// how to read it.
Report paper_report(const PaperFindings& findings);

} // namespace multipath
