#include "reports/studies/chart/chart.hpp"

#include "native/numerics/line_fit.hpp"
#include "reference/oracles/oracles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace crossgrain::studies {
namespace {

using catalog::ChartedError;
using compare::Combined;

struct Reference {
    double value = 0, standard_error = 0;
    std::string code;         ///< whose result it is; empty for a closed form
    std::size_t variant = 0;  ///< in which that code has it
};

/// The result of the first code that has the variant.
std::optional<Reference> converged_reference(const judge::CaseRuns& runs,
                                             const ChartedError& charted) {
    const auto& variants = runs.the_case().variants;
    for (const auto& code : runs.codes()) {
        for (std::size_t v = 0; v < variants.size(); ++v) {
            if (variants[v].name != charted.against.name || runs.absence(code, v)) continue;
            const auto best = runs.combined(code, v, 0, charted.observable);
            if (!best) continue;
            const auto& m = best->measurement;
            return Reference{m.value, m.standard_error, code, v};
        }
    }
    return std::nullopt;
}

std::optional<Reference> reference_of(const judge::CaseRuns& runs, const ChartedError& charted,
                                      std::size_t variant) {
    if (charted.against.kind == catalog::Reference::Kind::converged) {
        return converged_reference(runs, charted);
    }
    const auto exact =
        oracles::exact_value(to_string(charted.against), runs.the_case().scene(variant, 0, 1));
    if (!exact) return std::nullopt;
    return Reference{.value = *exact, .standard_error = 0, .code = {}, .variant = {}};
}

/// Least cost of a run in the variant.
double least_seconds(const judge::CaseRuns& runs, const std::string& code, std::size_t variant) {
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t r = 0; r < runs.replicas(code, variant, 0); ++r) {
        if (const auto* run = runs.find(code, variant, 0, r)) least = std::min(least, run->cpu_s);
    }
    return least;
}

/// The name of a variant without the numbers it is swept over: "predicted/double" of
/// "predicted/double/dt=0.002". A variant that is laid over the scene is a method of its own.
std::string method_of(const catalog::Variant& variant) {
    std::string method = variant.name;
    for (const auto& [key, text] : variant.parameters) {
        if (text.find_first_not_of("0123456789.e+-") != std::string::npos) continue;
        const std::string swept = key + "=" + text;
        if (const auto at = method.find(swept); at != std::string::npos) {
            method.erase(at, swept.size());
        }
    }
    return method;
}

/// Start-up of each code: runs of one method, which differ in length only, tell it.
std::map<std::string, double> start_ups(const judge::CaseRuns& runs) {
    const auto& variants = runs.the_case().variants;
    std::map<std::string, std::map<std::string, std::vector<std::pair<double, double>>>> methods;
    for (const auto& code : runs.codes()) {
        for (std::size_t v = 0; v < variants.size(); ++v) {
            const auto* run = runs.find(code, v, 0, 0);
            if (run == nullptr) continue;
            methods[code][method_of(variants[v])].emplace_back(run->work,
                                                               least_seconds(runs, code, v));
        }
    }
    std::map<std::string, double> seconds;
    for (const auto& [code, by_method] : methods) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [method, points] : by_method)
            least = std::min(least, start_up(points));
        seconds[code] = std::isfinite(least) ? least : 0.0;
    }
    return seconds;
}

ChartPoint point_of(const judge::CaseRuns& runs, const std::string& code, std::size_t v,
                    const Combined& found, const Reference& reference, double margin,
                    double start) {
    const auto& variant = runs.the_case().variants[v];
    const auto& m = found.measurement;
    ChartPoint point{.code = code,
                     .variant = variant.name,
                     .drops = variant.drops,
                     .parameters = variant.parameters,
                     .runs = found.replicas,
                     .start_s = start,
                     .value = m.value,
                     .bias = m.value - reference.value,
                     .bias_stderr = std::hypot(m.standard_error, reference.standard_error)};
    point.cpu_s = std::max(least_seconds(runs, code, v) - start, 0.0);
    point.scatter = m.standard_error * std::sqrt(static_cast<double>(found.replicas));
    point.error = std::hypot(point.bias, point.scatter);
    point.accurate = point.error <= margin;
    return point;
}

class ChartMaker {
  public:
    explicit ChartMaker(const judge::CaseReport& item)
        : item_(item), start_ups_(start_ups(item.runs)) {}

    Chart operator()() {
        chart_.case_name = item_.the_case->name;
        chart_.title = item_.the_case->title;
        for (const auto& charted : item_.the_case->charted)
            chart_.observables.push_back(observable(charted));
        add_absences();
        return std::move(chart_);
    }

  private:
    ChartedObservable observable(const ChartedError& charted) {
        ChartedObservable result{.observable = charted.observable,
                                 .against = to_string(charted.against),
                                 .reason = charted.reason,
                                 .margin = charted.margin};
        for (std::size_t v = 0; v < item_.the_case->variants.size(); ++v) {
            const auto reference = reference_of(item_.runs, charted, v);
            if (!reference) {
                result.problem = fmt::format("'{}' has no value here", result.against);
                continue;
            }
            result.reference = reference->value;
            result.reference_stderr = reference->standard_error;
            for (const auto& code : item_.runs.codes())
                add_point(code, v, *reference, result);
        }
        if (!result.points.empty()) result.problem.clear();
        mark_front(result.points);
        return result;
    }

    void add_point(const std::string& code, std::size_t v, const Reference& reference,
                   ChartedObservable& result) {
        if (item_.runs.absence(code, v)) return;
        const auto& name = item_.the_case->variants[v].name;
        // Its distance from itself says nothing.
        if (code == reference.code && v == reference.variant) return;
        const auto found = item_.runs.combined(code, v, 0, result.observable);
        if (!found) {
            chart_.failures.push_back({code, name, "not_measured",
                                       fmt::format("no '{}' in this run", result.observable)});
            return;
        }
        result.unit = found->measurement.unit;
        result.points.push_back(
            point_of(item_.runs, code, v, *found, reference, result.margin, start_ups_.at(code)));
    }

    void add_absences() {
        for (const auto& code : item_.runs.codes()) {
            for (std::size_t v = 0; v < item_.the_case->variants.size(); ++v) {
                const auto absence = item_.runs.absence(code, v);
                if (!absence) continue;
                chart_.failures.push_back({code, item_.the_case->variants[v].name,
                                           compare::to_string(absence->outcome), absence->reason});
            }
        }
    }

    const judge::CaseReport& item_;
    std::map<std::string, double> start_ups_;
    Chart chart_;
};

}  // namespace

double start_up(const std::vector<std::pair<double, double>>& work_and_seconds) {
    // Weighted least squares of t = a + b w with weights 1/t^2: equal relative errors.
    std::vector<double> work, seconds;
    double weights = 0;
    for (const auto& [w, t] : work_and_seconds) {
        if (!(t > 0)) return 0;
        work.push_back(w);
        seconds.push_back(t);
        weights += 1 / (t * t);
    }
    if (work.size() < 2 || std::ranges::max(work) == std::ranges::min(work)) return 0;
    const numerics::LineFit fit = numerics::fit_line(work, seconds, seconds);
    // Squares of the works about their mean, over their squares: they hardly differ.
    if (!(1 / (weights * fit.intercept_variance) > 1e-9)) return 0;
    return std::max(fit.intercept, 0.0);
}

void mark_front(std::vector<ChartPoint>& points) {
    std::ranges::stable_sort(points, {}, [](const ChartPoint& p) { return p.cpu_s + p.start_s; });
    double best = std::numeric_limits<double>::infinity();
    for (ChartPoint& point : points) {
        // What leaves physics out answers another question.
        point.on_front = point.drops.empty() && point.error < best;
        if (point.on_front) best = point.error;
    }
}

Chart chart_of(const judge::CaseReport& item) {
    return ChartMaker(item)();
}

}  // namespace crossgrain::studies
