// What the report pages are drawn from (schema: README.md here).
#pragma once

#include "reports/session/session.hpp"
#include "reports/studies/history.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crossgrain::reports {

/// Everything that is known of a call's cases, with curves. `command`: as people type it.
[[nodiscard]] nlohmann::json report_document(const session::SessionReport& report,
                                             const std::vector<studies::HistorySeries>& history,
                                             const std::string& command);

}  // namespace crossgrain::reports
