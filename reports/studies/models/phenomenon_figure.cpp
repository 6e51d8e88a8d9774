#include "reports/studies/models/phenomenon_figure.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

namespace crossgrain::studies {
namespace {

/// The column of a series, or null.
const std::vector<double>* column(const measure::Series& series, const std::string& name) {
    const auto found = std::ranges::find(series.columns, name);
    if (found == series.columns.end()) return nullptr;
    return &series.values[static_cast<std::size_t>(found - series.columns.begin())];
}

struct Points {
    std::vector<double> x, y;
};

/// The rows of a series that a curve asks for; nothing without its columns.
std::optional<Points> points_of(const TableCurve& curve, const measure::Series& series) {
    const auto* x = column(series, curve.x);
    const auto* y = column(series, curve.y);
    if (x == nullptr || y == nullptr) return std::nullopt;
    Points points;
    for (std::size_t row = 0; row < x->size(); ++row) {
        const bool counts = std::ranges::all_of(curve.where, [&](const auto& condition) {
            const auto* values = column(series, condition.first);
            return values != nullptr && (*values)[row] == condition.second;
        });
        if (!counts || !std::isfinite((*x)[row]) || !std::isfinite((*y)[row])) continue;
        points.x.push_back((*x)[row]);
        points.y.push_back((*y)[row]);
    }
    return points;
}

bool same_abscissas(const Points& a, const Points& b) {
    constexpr double rounding = 1e-9;
    return std::ranges::equal(a.x, b.x, [](double one, double other) {
        return std::abs(one - other) <= rounding * std::max(std::abs(one), std::abs(other));
    });
}

void average(std::span<const Points> replicas, FilledCurve& filled) {
    filled.x = replicas.front().x;
    for (std::size_t row = 0; row < filled.x.size(); ++row) {
        std::vector<double> values;
        for (const Points& replica : replicas)
            values.push_back(replica.y[row]);
        const auto mean = numerics::mean_with_error(values);
        filled.y.push_back(mean.value);
        filled.standard_error.push_back(mean.standard_error);
    }
}

void fill_from_series(const TableCurve& curve, const judge::CaseReport& report,
                      FilledCurve& filled) {
    std::vector<Points> replicas;
    for (const auto& run : report.runs.records()) {
        if (run.code != curve.code || run.variant != curve.variant ||
            run.status != store::RunStatus::ok)
            continue;
        for (const auto& series : run.results.series) {
            if (series.name != curve.series) continue;
            if (auto points = points_of(curve, series)) replicas.push_back(std::move(*points));
        }
    }
    if (replicas.empty()) return;
    const bool alike = std::ranges::all_of(
        replicas, [&](const Points& replica) { return same_abscissas(replica, replicas.front()); });
    average(std::span(replicas).first(alike ? replicas.size() : 1), filled);
}

void fill_from_sweep(const TableCurve& curve, const judge::CaseReport& report,
                     FilledCurve& filled) {
    struct Point {
        double x, y, standard_error;
    };
    std::vector<Point> points;
    const auto& variants = report.the_case->variants;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const auto text = variants[v].parameter(curve.along);
        if (!text || report.runs.absence(curve.code, v)) continue;
        const auto measured = report.runs.combined(curve.code, v, 0, curve.observable);
        double x = 0;
        const auto parsed = std::from_chars(text->data(), text->data() + text->size(), x);
        if (!measured || parsed.ec != std::errc()) continue;
        points.push_back({x, measured->measurement.value, measured->measurement.standard_error});
    }
    std::ranges::sort(points, {}, &Point::x);
    for (const Point& point : points) {
        filled.x.push_back(point.x);
        filled.y.push_back(point.y);
        filled.standard_error.push_back(point.standard_error);
    }
}

}  // namespace

std::vector<FilledFigure> fill_figures(const Phenomenon& phenomenon,
                                       const std::vector<judge::CaseReport>& cases) {
    std::vector<FilledFigure> figures;
    for (const TableFigure& figure : phenomenon.figures) {
        FilledFigure filled{.title = figure.title, .x = figure.x, .y = figure.y, .curves = {}};
        for (const TableCurve& curve : figure.curves) {
            const auto report = std::ranges::find_if(cases, [&](const judge::CaseReport& one) {
                return one.the_case->name == curve.case_name;
            });
            if (report == cases.end()) continue;
            FilledCurve one{.title = curve.title, .code = curve.code};
            const auto fill = curve.series.empty() ? fill_from_sweep : fill_from_series;
            fill(curve, *report, one);
            if (!one.x.empty()) filled.curves.push_back(std::move(one));
        }
        if (!filled.curves.empty()) figures.push_back(std::move(filled));
    }
    return figures;
}

nlohmann::json json_of(const std::vector<FilledFigure>& figures) {
    auto all = nlohmann::json::array();
    for (const FilledFigure& figure : figures) {
        auto curves = nlohmann::json::array();
        for (const FilledCurve& curve : figure.curves) {
            curves.push_back({{"title", curve.title},
                              {"code", curve.code},
                              {"x", curve.x},
                              {"y", curve.y},
                              {"stderr", curve.standard_error}});
        }
        all.push_back({{"title", figure.title},
                       {"x", figure.x},
                       {"y", figure.y},
                       {"curves", std::move(curves)}});
    }
    return all;
}

}  // namespace crossgrain::studies
