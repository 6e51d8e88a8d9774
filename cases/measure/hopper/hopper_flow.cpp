#include "cases/measure/hopper/hopper_flow.hpp"

#include "cases/measure/hopper/hopper_replicas.hpp"
#include "native/numerics/line_fit.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

/// Filling before each iteration and after the last; shape (iterations + 1).
std::vector<double> fillings(std::span<const double> flow, double sites) {
    std::vector<double> filling{1.0};
    double left = sites;
    for (const double grains : flow) {
        left -= grains;
        filling.push_back(left / sites);
    }
    return filling;
}

std::size_t iterations_above(std::span<const double> filling, double down_to) {
    const auto end = std::ranges::find_if(filling, [&](double f) { return f < down_to; });
    return static_cast<std::size_t>(end - filling.begin());
}

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// d ln(rate)/d ln(filling) over stretches of equal length, so that single iterations without flow
/// do not matter. Nothing if a whole stretch has no flow or the filling hardly changes.
std::optional<double> exponent_in_filling(std::span<const double> flow,
                                          std::span<const double> filling) {
    constexpr std::size_t stretches = 10;
    const std::size_t length = flow.size() / stretches;
    if (length == 0 || filling[flow.size() - 1] > 0.8) return std::nullopt;
    std::vector<double> x, y;
    for (std::size_t s = 0; s < stretches; ++s) {
        const double rate = mean_of(flow.subspan(s * length, length));
        if (rate <= 0) return std::nullopt;
        x.push_back(std::log(mean_of(filling.subspan(s * length, length))));
        y.push_back(std::log(rate));
    }
    return numerics::line_through(x, y).slope;
}

bool has_ended(std::span<const double> flow) {
    const std::size_t tail = std::max<std::size_t>(1, flow.size() / 10);
    return std::ranges::all_of(flow.last(tail), [](double grains) { return grains == 0; });
}

}  // namespace

HopperFlow::HopperFlow(const scene::HopperAutomaton& scene, HopperFlowOptions options)
    : scene_(scene), options_(options) {
    if (scene.angles.size() != 1) throw std::invalid_argument("the scene has more than one angle");
    check_ranges(options);
}

void HopperFlow::add(const scene::HopperFrame& frame) {
    if (!frame.last) return;
    sites_ = static_cast<double>(frame.state.size());
    flow_.emplace_back(frame.flow.begin(), frame.flow.end());
}

void HopperFlow::append_series(Results& results) const {
    constexpr std::size_t rows = 1000;
    Series series{.name = "flow",
                  .columns = {"iteration", "rate", "standard_error", "filling"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"iterations", "grains per iteration", "grains per iteration", "1"}};
    const std::size_t iterations = flow_.front().size();
    const std::size_t stride = (iterations + rows - 1) / rows;
    std::vector<std::vector<double>> filling;
    for (const auto& flow : flow_)
        filling.push_back(fillings(flow, sites_));
    for (std::size_t i = 0; i < iterations; i += stride) {
        std::vector<double> rates, left;
        for (std::size_t r = 0; r < flow_.size(); ++r) {
            const std::size_t length = std::min(stride, iterations - i);
            rates.push_back(mean_of(std::span(flow_[r]).subspan(i, length)));
            left.push_back(filling[r][i]);
        }
        const numerics::MeanWithError rate = numerics::mean_with_error(rates);
        series.values[0].push_back(static_cast<double>(i + 1));
        series.values[1].push_back(rate.value);
        series.values[2].push_back(rate.standard_error);
        series.values[3].push_back(mean_of(left));
    }
    results.series.push_back(std::move(series));
}

void HopperFlow::append_state(std::span<const double> residues, Results& results) const {
    const double least = std::ranges::min(residues);
    Finding finding{.name = "state", .label = "ok", .detail = "the hopper has emptied"};
    if (least > 0) {
        finding.label = "no meaning";
        finding.detail = fmt::format("the flow has ended, {:.1f} % or more of the grains lie on "
                                     "the walls for ever",
                                     100 * least);
    }
    results.findings.push_back(std::move(finding));
}

void HopperFlow::finish(Results& results) {
    if (flow_.size() < static_cast<std::size_t>(scene_.replicas)) return;
    std::vector<double> rates, exponents, losses, residues;
    for (const auto& flow : flow_) {
        const std::vector<double> filling = fillings(flow, sites_);
        const std::size_t steady =
            std::min(iterations_above(filling, options_.down_to), flow.size());
        const auto steady_flow = std::span(flow).first(steady);
        if (steady > 0) rates.push_back(mean_of(steady_flow));
        if (const auto a = exponent_in_filling(steady_flow, filling)) exponents.push_back(*a);
        const auto loss = std::ranges::find_if(flow, [&](double g) { return g < scene_.outlet; });
        if (loss != flow.end()) {
            losses.push_back(filling[static_cast<std::size_t>(loss - flow.begin())]);
        }
        if (has_ended(flow)) residues.push_back(filling.back());
    }
    const std::map<std::string, double> settings{{"down_to", options_.down_to}};
    const auto append = [&](const char* name, std::span<const double> samples, const char* unit) {
        if (samples.size() == flow_.size()) {
            append_replica_mean(results, name, samples, unit, settings);
        }
    };
    append("flow_rate", rates, "grains per iteration");
    append("flow_exponent", exponents, "1");
    append("filling_at_first_loss", losses, "1");
    append("residue", residues, "1");
    if (residues.size() == flow_.size()) append_state(residues, results);
    append_series(results);
}

}  // namespace crossgrain::measure
