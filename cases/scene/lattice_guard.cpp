#include "cases/scene/lattice_guard.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

namespace crossgrain::scene {

GasFrameGuard::GasFrameGuard(const LatticeGas& scene)
    : sampling_(scene.sampling), number_stays_(scene.ends == PipeEnds::periodic),
      expected_step_(scene.sampling.burn_in) {}

GasFrameGuard::GasFrameGuard(const SyntheticSignal& scene)
    : sampling_(scene.sampling), number_stays_(false), expected_step_(scene.sampling.burn_in) {}

void GasFrameGuard::operator()(const GasFrame& frame) {
    check_schedule(frame);
    check_values(frame);
    check_number(frame);
    add_to_history(frame);
    saturated_ = std::ranges::any_of(frame.saturated, [](auto flag) { return flag != 0; });
    expected_step_ += sampling_.every;
}

void GasFrameGuard::check_schedule(const GasFrame& frame) const {
    const bool ends_here = std::ranges::any_of(frame.saturated, [](auto f) { return f != 0; });
    const bool in_time = ends_here ? frame.step <= expected_step_ : frame.step == expected_step_;
    if (in_time && !saturated_ && frame.step <= sampling_.burn_in + sampling_.steps) return;
    throw TrajectoryError(fmt::format("frame at step {} where step {} was due: frames are lost, "
                                      "repeated, or beyond the end of the run",
                                      frame.step, expected_step_));
}

void GasFrameGuard::check_values(const GasFrame& frame) const {
    const std::size_t bins = static_cast<std::size_t>(sampling_.bins());
    const std::size_t size = bins * static_cast<std::size_t>(sampling_.replicas);
    const auto fits = [&](std::size_t have, bool wanted) { return have == (wanted ? size : 0); };
    if (frame.bins != bins || frame.bins * frame.replicas != size ||
        !fits(frame.count.size(), sampling_.fields.count) ||
        !fits(frame.rests.size(), sampling_.fields.rests) ||
        !fits(frame.momentum.size(), sampling_.fields.momentum)) {
        throw TrajectoryError(fmt::format("frame at step {} holds {} bins of {} replicas, the "
                                          "scene has {} of {}",
                                          frame.step, frame.bins, frame.replicas, bins,
                                          sampling_.replicas));
    }
    if (frame.count.empty()) return;
    for (std::size_t i = 0; i < size; ++i) {
        const int rests = frame.rests.empty() ? 0 : frame.rests[i];
        const int momentum = frame.momentum.empty() ? 0 : frame.momentum[i];
        const int movers = frame.count[i] - rests;
        if (movers >= 0 && std::abs(momentum) <= 2 * movers) continue;
        throw TrajectoryError(fmt::format(
            "bin {} at step {} has {} particles, of these {} at rest, and momentum {} half sites "
            "per step: that cannot be",
            i / frame.replicas, frame.step, frame.count[i], rests, momentum));
    }
}

void GasFrameGuard::check_number(const GasFrame& frame) {
    if (!number_stays_ || frame.count.empty() || !frame.saturated.empty()) return;
    std::vector<std::uint64_t> number(frame.replicas);
    for (std::size_t i = 0; i < frame.count.size(); ++i)
        number[i % frame.replicas] += frame.count[i];
    if (number_.empty()) number_ = number;
    const auto odd = std::ranges::mismatch(number, number_);
    if (odd.in1 == number.end()) return;
    throw TrajectoryError(
        fmt::format("replica {} has {} particles at step {}, it had {}: a periodic pipe loses none",
                    odd.in1 - number.begin(), *odd.in1, frame.step, *odd.in2));
}

void GasFrameGuard::add_to_history(const GasFrame& frame) {
    // A multiplicative digest (Fowler, Noll & Vo), one value at a time.
    constexpr std::uint64_t basis = 0xcbf29ce484222325, prime = 0x100000001b3;
    std::vector<std::uint64_t> digest(frame.replicas, basis);
    const auto take = [&](const auto& field) {
        for (std::size_t i = 0; i < field.size(); ++i) {
            auto& own = digest[i % frame.replicas];
            own = (own ^ static_cast<std::uint16_t>(field[i])) * prime;
        }
    };
    take(frame.count);
    take(frame.momentum);
    if (history_.empty()) {
        history_.assign(frame.replicas, basis);
        changed_.assign(frame.replicas, false);
        last_ = digest;
    }
    for (std::size_t r = 0; r < frame.replicas; ++r) {
        changed_[r] = changed_[r] || digest[r] != last_[r];
        history_[r] = (history_[r] ^ digest[r]) * prime;
    }
    last_ = std::move(digest);
}

void GasFrameGuard::check_history() const {
    std::map<std::uint64_t, std::size_t> seen;
    for (std::size_t r = 0; r < history_.size(); ++r) {
        if (!changed_[r]) continue;
        const auto [first, is_new] = seen.emplace(history_[r], r);
        if (is_new) continue;
        throw TrajectoryError(fmt::format("replicas {} and {} had the same history: they are one "
                                          "sample, not two (the same random numbers?)",
                                          first->second, r));
    }
}

void GasFrameGuard::finish() const {
    check_history();
    if (saturated_ || expected_step_ > sampling_.burn_in + sampling_.steps) return;
    throw TrajectoryError(fmt::format("frames end before step {}", expected_step_));
}

void HopperFrameGuard::operator()(const HopperFrame& frame) {
    check_schedule(frame);
    check_number(frame);
    expect_next(frame);
}

void HopperFrameGuard::check_schedule(const HopperFrame& frame) const {
    const bool in_order = frame.angle_index == angle_index_ && frame.replica == replica_ &&
                          frame.iteration == iteration_ &&
                          frame.last == (frame.iteration == scene_.iterations) &&
                          frame.flow.size() == static_cast<std::size_t>(frame.iteration);
    if (in_order) return;
    throw TrajectoryError(fmt::format(
        "frame of angle {}, replica {}, iteration {} (with the flow of {}) where angle {}, replica "
        "{}, iteration {} was due",
        frame.angle_index + 1, frame.replica + 1, frame.iteration, frame.flow.size(),
        angle_index_ + 1, replica_ + 1, iteration_));
}

void HopperFrameGuard::check_number(const HopperFrame& frame) {
    const auto inside = frame.state.size() -
                        static_cast<std::size_t>(std::ranges::count(frame.state, std::uint8_t{0}));
    const std::uint64_t grains =
        inside + std::accumulate(frame.flow.begin(), frame.flow.end(), std::uint64_t{0});
    if (frame.iteration == 0) grains_ = grains;
    if (grains == grains_) return;
    throw TrajectoryError(fmt::format("angle {}, replica {}, iteration {}: {} grains are in the "
                                      "hopper or have left it, there were {}",
                                      frame.angle_index + 1, frame.replica + 1, frame.iteration,
                                      grains, grains_));
}

void HopperFrameGuard::expect_next(const HopperFrame& frame) {
    if (!frame.last) {
        const std::int64_t next = (frame.iteration / scene_.every + 1) * scene_.every;
        iteration_ = std::min(next, scene_.iterations);
        return;
    }
    iteration_ = 0;
    if (++replica_ < scene_.replicas) return;
    replica_ = 0;
    ++angle_index_;
}

void HopperFrameGuard::finish() const {
    if (angle_index_ == scene_.angles.size()) return;
    throw TrajectoryError(
        fmt::format("frames end in angle {} of {}, replica {}, before iteration {}",
                    angle_index_ + 1, scene_.angles.size(), replica_ + 1, iteration_));
}

}  // namespace crossgrain::scene
