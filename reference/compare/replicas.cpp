#include "reference/compare/replicas.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace crossgrain::compare {
namespace {

constexpr std::size_t fewest_for_scatter = 4;

void check(std::span<const measure::Measurement> replicas) {
    if (replicas.empty()) throw std::invalid_argument("no replicas to combine");
    const auto& first = replicas.front();
    for (const auto& one : replicas) {
        if (one.observable != first.observable || one.unit != first.unit) {
            throw std::invalid_argument(
                fmt::format("replicas measure different things: '{}' ({}) and '{}' ({})",
                            first.observable, first.unit, one.observable, one.unit));
        }
        const bool finite = std::isfinite(one.value) && std::isfinite(one.standard_error) &&
                            std::isfinite(one.systematic);
        if (!finite || one.standard_error < 0) {
            throw std::invalid_argument(fmt::format("a replica of '{}' has value {} +- {}",
                                                    one.observable, one.value, one.standard_error));
        }
    }
}

bool some_error_is_missing(std::span<const measure::Measurement> replicas) {
    const bool missing =
        std::ranges::any_of(replicas, [](const auto& one) { return one.standard_error == 0; });
    const bool differ = std::ranges::any_of(
        replicas, [&](const auto& one) { return one.value != replicas.front().value; });
    return missing && differ;
}

double within_run_error(std::span<const measure::Measurement> replicas) {
    double squares = 0;
    for (const auto& one : replicas)
        squares += one.standard_error * one.standard_error;
    return std::sqrt(squares) / static_cast<double>(replicas.size());
}

/// An angle fitted to a wall is not the same to the last bit in every replica.
bool same_setting(double a, double b) {
    constexpr double rounding = 1e-9;
    return a == b || std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

std::map<std::string, double> shared_settings(std::span<const measure::Measurement> replicas) {
    std::map<std::string, double> shared = replicas.front().settings;
    std::erase_if(shared, [&](const auto& setting) {
        return std::ranges::any_of(replicas, [&](const auto& one) {
            const auto found = one.settings.find(setting.first);
            return found == one.settings.end() || !same_setting(found->second, setting.second);
        });
    });
    return shared;
}

}  // namespace

Combined combine(std::span<const measure::Measurement> replicas) {
    check(replicas);
    std::vector<double> values;
    double systematic = 0;
    std::size_t samples = 0;
    for (const auto& one : replicas) {
        values.push_back(one.value);
        systematic += one.systematic / static_cast<double>(replicas.size());
        samples += one.n;
    }
    const numerics::MeanWithError mean = numerics::mean_with_error(values);
    Combined combined{.measurement = {.observable = replicas.front().observable,
                                      .value = mean.value,
                                      .systematic = systematic,
                                      .n = samples,
                                      .unit = replicas.front().unit,
                                      .settings = shared_settings(replicas)},
                      .replicas = replicas.size()};
    const bool by_scatter =
        replicas.size() >= fewest_for_scatter || some_error_is_missing(replicas);
    if (by_scatter) {
        combined.measurement.standard_error = mean.standard_error;
        combined.degrees_of_freedom = static_cast<double>(replicas.size()) - 1;
        return combined;
    }
    combined.basis = ErrorBasis::within_run;
    combined.measurement.standard_error = within_run_error(replicas);
    combined.degrees_of_freedom =
        combined.measurement.standard_error == 0
            ? std::numeric_limits<double>::infinity()
            : static_cast<double>(samples) - static_cast<double>(replicas.size());
    return combined;
}

}  // namespace crossgrain::compare
