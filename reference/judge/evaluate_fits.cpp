// Measurements over the variants of a case: exponents, Beverloo's constants, slopes.
#include "reference/judge/evaluate.hpp"

#include "reference/compare/bootstrap.hpp"
#include "reference/compare/sweep_fit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

namespace crossgrain::judge {
namespace {

/// A variant as a point of the fit.
struct Point {
    std::size_t variant = 0;
    compare::SweepPoint at;
    std::vector<double> by_replica;  ///< y, shape (replicas)
    double along = 0;                ///< x before any tangent
    std::size_t replicas = 0;
};

std::optional<double> number_in(const std::optional<std::string>& text) {
    double value = 0;
    if (!text) return std::nullopt;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (error != std::errc() || end != text->data() + text->size()) return std::nullopt;
    return value;
}

/// x of a variant: of the sweep, of the settings y was measured with, or measured itself.
std::optional<double> abscissa(const CaseRuns& runs, const catalog::Fit& fit,
                               const std::string& code, std::size_t variant,
                               const measure::Measurement& y) {
    const auto& of_case = runs.the_case().variants[variant];
    if (const auto swept = number_in(of_case.parameter(fit.along))) return swept;
    if (const auto set = y.settings.find(fit.along); set != y.settings.end()) return set->second;
    const auto measured = runs.combined(code, variant, 0, fit.along);
    if (!measured) return std::nullopt;
    return measured->measurement.value;
}

std::vector<double> replicas_of(const CaseRuns& runs, const std::string& code, std::size_t variant,
                                const std::string& observable) {
    std::vector<double> values;
    for (std::int64_t replica = 0; replica < runs.replicas(code, variant, 0); ++replica) {
        const auto* run = runs.find(code, variant, 0, replica);
        if (run == nullptr) continue;
        for (const auto& m : run->results.measurements) {
            if (m.observable == observable) values.push_back(m.value);
        }
    }
    return values;
}

bool takes_part(const catalog::Fit& fit, const std::string& variant) {
    return fit.variants.empty() || std::ranges::any_of(fit.variants, [&](const auto& pattern) {
               return catalog::matches(pattern, variant);
           });
}

/// Ascending in x. Variants that did not run are left out; their number is in the settings.
std::vector<Point> points_of(const CaseRuns& runs, const catalog::Fit& fit,
                             const std::string& code) {
    std::vector<Point> points;
    for (std::size_t v = 0; v < runs.the_case().variants.size(); ++v) {
        if (!takes_part(fit, runs.the_case().variants[v].name)) continue;
        if (runs.absence(code, v)) continue;
        const auto y = runs.combined(code, v, 0, fit.observable);
        if (!y) continue;
        const auto x = abscissa(runs, fit, code, v, y->measurement);
        constexpr double rounding = 1e-9;  // of angles that are fitted to walls
        if (!x || (fit.from && *x < *fit.from - rounding) || (fit.to && *x > *fit.to + rounding)) {
            continue;
        }
        points.push_back({.variant = v,
                          .at = {.x = fit.tangent ? std::tan(*x * std::numbers::pi / 180) : *x,
                                 .y = y->measurement.value,
                                 .standard_error = y->measurement.standard_error},
                          .by_replica = replicas_of(runs, code, v, fit.observable),
                          .along = *x,
                          .replicas = y->replicas});
    }
    std::ranges::sort(points, {}, [](const Point& p) { return p.at.x; });
    return points;
}

using Law =
    std::function<std::optional<compare::SweepEstimate>(std::span<const compare::SweepPoint>)>;

compare::FittedValue value_of(const Law& law) {
    return [&law](std::span<const compare::SweepPoint> points) -> std::optional<double> {
        const auto estimate = law(points);
        if (!estimate) return std::nullopt;
        return estimate->value;
    };
}

std::optional<compare::SweepEstimate>
fit_inverse_exponent(std::span<const compare::SweepPoint> points) {
    auto fit = compare::fit_exponent(points);
    if (fit) fit->value = -fit->value;
    return fit;
}

Law outlet_law(compare::SweepEstimate compare::OutletLaw::*part) {
    return [part](std::span<const compare::SweepPoint> points) {
        const auto law = compare::fit_outlet_law(points);
        return law ? std::optional((*law).*part) : std::nullopt;
    };
}

class FitOfCode {
  public:
    FitOfCode(const CaseRuns& runs, const catalog::Fit& fit, std::string code,
              Evaluation& evaluation)
        : fit_(fit), code_(std::move(code)), points_(points_of(runs, fit, code_)),
          evaluation_(evaluation), runs_(runs) {
        for (const Point& point : points_) {
            at_.push_back(point.at);
            replicated_.push_back({.x = point.at.x, .y = point.by_replica});
        }
    }

    void append() {
        switch (fit_.law) {
        case catalog::FitLaw::exponent:
            return append_fit("", compare::fit_exponent);
        case catalog::FitLaw::inverse_exponent:
            return append_fit("", fit_inverse_exponent);
        case catalog::FitLaw::outlet:
            append_fit("_factor", outlet_law(&compare::OutletLaw::factor));
            return append_fit("_cut", outlet_law(&compare::OutletLaw::cut));
        case catalog::FitLaw::outlet_exponent:
            return append_fit("", compare::fit_outlet_exponent);
        case catalog::FitLaw::local_slope:
            return append_slopes();
        }
    }

  private:
    CodeMeasurement measurement(const std::string& suffix,
                                const compare::SweepEstimate& estimate) const {
        CodeMeasurement m{.code = code_};
        m.combined.measurement = {.observable = fit_.name + suffix,
                                  .value = estimate.value,
                                  .standard_error = estimate.standard_error,
                                  .n = points_.size(),
                                  .settings = {{"points", static_cast<double>(points_.size())},
                                               {"from", points_.front().along},
                                               {"to", points_.back().along}}};
        m.combined.replicas = points_.front().replicas;
        m.combined.basis = compare::ErrorBasis::within_run;
        m.combined.degrees_of_freedom = estimate.degrees_of_freedom;
        return m;
    }

    /// The error is the larger of the fit's own and that of resampled replicas; both are in the
    /// settings.
    void append_fit(const std::string& suffix, const Law& law) {
        const auto estimate = law(at_);
        if (!estimate) return;
        CodeMeasurement found = measurement(suffix, *estimate);
        auto& m = found.combined.measurement;
        if (const auto resampled = compare::bootstrap_error(replicated_, value_of(law))) {
            m.settings["error_of_fit"] = m.standard_error;
            m.settings["error_of_bootstrap"] = *resampled;
            m.standard_error = std::max(m.standard_error, *resampled);
        }
        m.systematic = compare::systematic_over_windows(at_, value_of(law)).value_or(0);
        evaluation_.measurements.push_back(std::move(found));
    }

    /// Linear in the points: propagation is exact, and there is no window to choose.
    void append_slopes() {
        const auto slopes = compare::local_slopes(at_);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!slopes[i]) continue;
            CodeMeasurement slope = measurement("", *slopes[i]);
            slope.variant = runs_.the_case().variants[points_[i].variant].name;
            evaluation_.measurements.push_back(std::move(slope));
        }
    }

    const catalog::Fit& fit_;
    std::string code_;
    std::vector<Point> points_;
    std::vector<compare::SweepPoint> at_;
    std::vector<compare::ReplicatedPoint> replicated_;
    Evaluation& evaluation_;
    const CaseRuns& runs_;
};

}  // namespace

void evaluate_fits(const CaseRuns& runs, Evaluation& evaluation) {
    for (const catalog::Fit& fit : runs.the_case().fits) {
        for (const auto& code : runs.codes())
            FitOfCode(runs, fit, code, evaluation).append();
    }
}

}  // namespace crossgrain::judge
