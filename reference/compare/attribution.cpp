#include "reference/compare/attribution.hpp"

#include "reference/compare/student.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace crossgrain::compare {
namespace {

using numerics::mean_with_error;
using Settings = std::span<const std::vector<double>>;

constexpr double level = 0.05;

std::size_t switches_of(Settings values) {
    const std::size_t switches = std::bit_width(values.size()) - 1;
    if (!std::has_single_bit(values.size()) || switches < 1 || switches > most_switches) {
        throw std::invalid_argument(fmt::format("{} settings are not those of 1 to {} switches",
                                                values.size(), most_switches));
    }
    for (const auto& replicas : values) {
        if (replicas.size() < 2 || replicas.size() != values.front().size()) {
            throw std::invalid_argument(
                "an attribution needs the same two or more replicas in every setting");
        }
        if (!std::ranges::all_of(replicas, [](double value) { return std::isfinite(value); })) {
            throw std::invalid_argument("an attribution needs finite values");
        }
    }
    return switches;
}

/// |S|! (n - |S| - 1)!/n!, the share of the orders in which exactly S comes before a switch.
double share_of_orders(std::size_t before, std::size_t switches) {
    double share = 1.0 / static_cast<double>(switches);
    for (std::size_t k = 1; k <= before; ++k)
        share *= static_cast<double>(k) / static_cast<double>(switches - k);
    return share;
}

/// By replica. Shape (replicas).
std::vector<double> difference(const std::vector<double>& to, const std::vector<double>& from) {
    std::vector<double> by_replica(to.size());
    std::ranges::transform(to, from, by_replica.begin(), std::minus<>());
    return by_replica;
}

bool differs_from_zero(const numerics::MeanWithError& mean, std::size_t family) {
    const double probability = 1 - level / 2 / static_cast<double>(family);
    const double t = student_quantile(probability, static_cast<double>(mean.n - 1));
    return std::abs(mean.value) > t * mean.standard_error;
}

Contribution contribution(Settings values, std::size_t switches, std::size_t which) {
    const std::size_t bit = std::size_t{1} << which;
    std::vector<double> average(values.front().size());
    for (std::size_t before = 0; before < values.size(); ++before) {
        if ((before & bit) != 0) continue;
        const double share =
            share_of_orders(static_cast<std::size_t>(std::popcount(before)), switches);
        const auto made = difference(values[before | bit], values[before]);
        for (std::size_t r = 0; r < made.size(); ++r)
            average[r] += share * made[r];
    }
    const std::size_t all = values.size() - 1;
    Contribution result{.average = mean_with_error(average),
                        .first = mean_with_error(difference(values[bit], values[0])),
                        .last = mean_with_error(difference(values[all], values[all ^ bit]))};
    result.significant = differs_from_zero(result.average, switches);
    return result;
}

}  // namespace

Attribution attribute(Settings values) {
    const std::size_t switches = switches_of(values);
    const auto total = difference(values.back(), values.front());
    Attribution result{.a = mean_with_error(values.front()),
                       .b = mean_with_error(values.back()),
                       .difference = mean_with_error(total),
                       .contributions = {}};
    result.significant = differs_from_zero(result.difference, 1);
    std::vector<double> together = total;
    for (std::size_t i = 0; i < switches; ++i) {
        result.contributions.push_back(contribution(values, switches, i));
        const auto alone = difference(values[std::size_t{1} << i], values.front());
        std::ranges::transform(together, alone, together.begin(), std::minus<>());
    }
    result.interaction = mean_with_error(together);
    return result;
}

}  // namespace crossgrain::compare
