// Curves of several models in one pair of axes: what the figures of a phenomenon draw, from stored
// runs. Nothing is computed here beyond means over replicas.
#pragma once

#include "reports/session/session.hpp"
#include "reports/studies/models/phenomenon.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crossgrain::studies {

struct FilledCurve {
    std::string title, code;
    std::vector<double> x, y;
    std::vector<double> standard_error;  ///< of y, zero where one run tells none
};

struct FilledFigure {
    std::string title, x, y;
    std::vector<FilledCurve> curves;  ///< those that a stored run has points for
};

/// A series' columns are averaged over the replicas, where these have the same abscissas but for
/// rounding; else they are those of the first replica. Figures without a curve are left out.
[[nodiscard]] std::vector<FilledFigure> fill_figures(const Phenomenon& phenomenon,
                                                     const std::vector<judge::CaseReport>& cases);

[[nodiscard]] nlohmann::json json_of(const std::vector<FilledFigure>& figures);

}  // namespace crossgrain::studies
