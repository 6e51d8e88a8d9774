#include "cases/measure/bed/flow_depth.hpp"

#include "cases/measure/statistics/blocking.hpp"
#include "native/numerics/jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace crossgrain::measure {
namespace {

constexpr double bond_length = 1.25;  // in diameters
constexpr double lost_length = 1.5;

}  // namespace

FlowDepth::FlowDepth(const scene::Scene& scene, FlowDepthOptions options)
    : options_(options), period_x_(scene.periodic_x), period_y_(scene.periodic_y),
      diameter_(scene.grains.diameter),
      interval_(scene.dt * static_cast<double>(scene.frame_every)),
      search_(bond_length * scene.grains.diameter, scene.periodic_x, scene.periodic_y),
      next_(options.skip) {
    check_ranges(options_);
    const auto& bottom = scene.plates.bottom;
    if (!bottom || bottom->amplitude == 0 || !scene.periodic_x) return;
    period_ = bottom->period;
    layer_size_ = std::max<std::size_t>(
        1, static_cast<std::size_t>(*scene.periodic_x / diameter_ * (1 + 1e-12)));
}

void FlowDepth::add(const scene::Frame& frame) {
    if (!period_ || frame.time < next_ - interval_ * 0.5) return;
    if (!bonds_.empty()) end_period(frame);
    begin_period(frame);
    next_ += *period_;
}

void FlowDepth::begin_period(const scene::Frame& frame) {
    bonds_.clear();
    for (const scene::Contact& c : search_.find(frame.x, frame.y))
        bonds_.push_back({c.i, c.j});
    std::vector<std::size_t> by_height(frame.y.size());
    std::iota(by_height.begin(), by_height.end(), std::size_t{0});
    std::ranges::sort(by_height, {}, [&](std::size_t i) { return frame.y[i]; });
    layer_.resize(by_height.size());
    for (std::size_t rank = 0; rank < by_height.size(); ++rank)
        layer_[by_height[rank]] = rank / layer_size_;
}

void FlowDepth::end_period(const scene::Frame& frame) {
    const std::size_t layers = (layer_.size() + layer_size_ - 1) / layer_size_;
    Exchange exchange{.bonds = std::vector<double>(layers, 0.0),
                      .lost = std::vector<double>(layers, 0.0)};
    const double limit = lost_length * diameter_;
    for (const Bond& bond : bonds_) {
        const double dx = scene::nearest_image(frame.x[bond.i] - frame.x[bond.j], period_x_);
        const double dy = scene::nearest_image(frame.y[bond.i] - frame.y[bond.j], period_y_);
        const double lost = dx * dx + dy * dy > limit * limit ? 1.0 : 0.0;
        for (const std::size_t grain : {bond.i, bond.j}) {
            exchange.bonds[layer_[grain]] += 1;
            exchange.lost[layer_[grain]] += lost;
        }
    }
    exchanges_.push_back(std::move(exchange));
}

/// Share of lost bonds per layer over all periods but those from skip_from to below skip_to.
std::vector<double> FlowDepth::lost_shares(std::size_t skip_from, std::size_t skip_to) const {
    const std::size_t layers = exchanges_.front().bonds.size();
    std::vector<double> bonds(layers, 0.0), lost(layers, 0.0);
    for (std::size_t n = 0; n < exchanges_.size(); ++n) {
        if (n >= skip_from && n < skip_to) continue;
        std::ranges::transform(bonds, exchanges_[n].bonds, bonds.begin(), std::plus{});
        std::ranges::transform(lost, exchanges_[n].lost, lost.begin(), std::plus{});
    }
    std::vector<double> shares(layers, 0.0);
    for (std::size_t l = 0; l < layers; ++l) {
        // A layer without bonds is a gas: all of it flows.
        shares[l] = bonds[l] > 0 ? lost[l] / bonds[l] : 1.0;
    }
    return shares;
}

double FlowDepth::flowing_layers(const std::vector<double>& shares, double share) {
    return static_cast<double>(
        std::ranges::count_if(shares, [share](double lost) { return lost > share; }));
}

void FlowDepth::finish(Results& results) {
    constexpr std::size_t fewest = 12, batches = 6;
    const std::size_t periods = exchanges_.size();
    if (periods < fewest) return;
    const std::vector<double> shares = lost_shares(0, 0);
    const double layers = flowing_layers(shares, options_.share);
    std::vector<double> without_batch;
    for (std::size_t b = 0; b < batches; ++b) {
        without_batch.push_back(flowing_layers(
            lost_shares(b * periods / batches, (b + 1) * periods / batches), options_.share));
    }
    const double error = numerics::jackknife_error(without_batch);
    const double spread = (flowing_layers(shares, options_.share / 2) -
                           flowing_layers(shares, std::min(1.0, 2 * options_.share))) /
                          2;
    const double row = std::numbers::sqrt3 / 2 * diameter_;
    const std::map<std::string, double> settings{{"share", options_.share},
                                                 {"skip", options_.skip}};
    results.measurements.push_back({.observable = "flow_depth",
                                    .value = layers * row,
                                    .standard_error = error * row,
                                    .systematic = spread * row,
                                    .n = periods,
                                    .unit = "l",
                                    .settings = settings});
    results.measurements.push_back({.observable = "flowing_layers",
                                    .value = layers,
                                    .standard_error = error,
                                    .systematic = spread,
                                    .n = periods,
                                    .settings = settings});
    std::vector<double> lost_in_period;
    for (const Exchange& exchange : exchanges_) {
        const double bonds = std::accumulate(exchange.bonds.begin(), exchange.bonds.end(), 0.0);
        const double lost = std::accumulate(exchange.lost.begin(), exchange.lost.end(), 0.0);
        lost_in_period.push_back(bonds > 0 ? lost / bonds : 1.0);
    }
    if (const auto mean = blocked_mean(lost_in_period)) {
        results.measurements.push_back({.observable = "lost_bonds",
                                        .value = mean->value,
                                        .standard_error = mean->standard_error,
                                        .n = mean->blocks,
                                        .settings = settings});
    }
    Series profile{
        .name = "flow-profile", .columns = {"layer", "lost_bonds"}, .values = {{}, shares}};
    for (std::size_t l = 1; l <= shares.size(); ++l)
        profile.values[0].push_back(static_cast<double>(l));
    results.series.push_back(std::move(profile));
}

}  // namespace crossgrain::measure
