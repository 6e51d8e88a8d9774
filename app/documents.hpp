// The JSON that other tools and the report pages rely on.
#pragma once

#include "app/history.hpp"
#include "app/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>

namespace crossgrain::app {

/// {"codes": [{code, version, program, digest, status, reason, expresses}]}. Throws Interrupted.
[[nodiscard]] nlohmann::json codes_document(std::stop_token stop = {});

/// {"cases": [{case, runs, measurements, verdicts}]}, the answer of run and compare.
[[nodiscard]] nlohmann::json cases_document(const SessionReport& report);

/// {"pairs": [...]}, the answer of certify.
[[nodiscard]] nlohmann::json certificate_document(const SessionReport& report);

/// {"series": [...]}, the answer of history.
[[nodiscard]] nlohmann::json history_document(const std::vector<HistorySeries>& history);

/// All of it with curves, for the report pages (schema: reports/web/README.md).
[[nodiscard]] nlohmann::json report_document(const SessionReport& report,
                                             const std::vector<HistorySeries>& history,
                                             const Settings& settings);

}  // namespace crossgrain::app
