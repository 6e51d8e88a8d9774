// Spoiled frames of the lattice models.
#include "tests/selftest/selftest_frames.hpp"

#include "native/base/errors.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace crossgrain::selftest {
namespace {

CaseError unknown(const std::string& name, const char* model, const std::string& place) {
    return CaseError({.file = place,
                      .key = "defect.filter",
                      .problem = std::string("is not known for ") + model,
                      .got = "\"" + name + "\"",
                      .expected = "a filter of tests/selftest/selftest_frames.hpp"});
}

using scene::GasFrame;
using GasSink = FrameSinkOf<GasFrame>;

struct KeptGas {
    explicit KeptGas(const GasFrame& frame)
        : view(frame), count(frame.count.begin(), frame.count.end()),
          rests(frame.rests.begin(), frame.rests.end()),
          momentum(frame.momentum.begin(), frame.momentum.end()) {}
    [[nodiscard]] GasFrame frame() const {
        GasFrame all = view;
        all.count = count, all.rests = rests, all.momentum = momentum;
        return all;
    }
    GasFrame view;
    std::vector<std::uint16_t> count, rests;
    std::vector<std::int16_t> momentum;
};

template <class T>
void mirror(std::vector<T>& field, const GasFrame& frame) {
    if (field.empty()) return;
    for (std::size_t bin = 0; bin < frame.bins / 2; ++bin) {
        const auto at = [&](std::size_t b) {
            return field.begin() + static_cast<std::ptrdiff_t>(b * frame.replicas);
        };
        const auto n = static_cast<std::ptrdiff_t>(frame.replicas);
        std::swap_ranges(at(bin), at(bin) + n, at(frame.bins - 1 - bin));
    }
}

/// Replica r becomes a copy of replica source(r).
template <class T, class Source>
void copy_replicas(std::vector<T>& field, const GasFrame& frame, Source source) {
    const std::vector<T> original = field;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const std::size_t r = i % frame.replicas;
        field[i] = original[i - r + source(r)];
    }
}

template <class Source>
void copy_all(KeptGas& f, Source source) {
    copy_replicas(f.count, f.view, source);
    copy_replicas(f.rests, f.view, source);
    copy_replicas(f.momentum, f.view, source);
}

using SpoilGas = std::function<void(KeptGas&)>;

const std::map<std::string, SpoilGas>& gas_spoils() {
    static const std::map<std::string, SpoilGas> all{
        {"mirrored-bins",
         [](KeptGas& f) {
             mirror(f.count, f.view);
             mirror(f.rests, f.view);
             mirror(f.momentum, f.view);
         }},
        {"repeated-replica",
         [](KeptGas& f) {
             copy_all(f, [](std::size_t r) { return std::min<std::size_t>(r, 1); });
         }},
        {"doubled-replicas",
         [](KeptGas& f) { copy_all(f, [](std::size_t r) { return r / 2 * 2; }); }},
        {"lost-rests",
         [](KeptGas& f) {
             for (std::size_t i = 0; i < f.rests.size(); ++i)
                 f.count[i] = static_cast<std::uint16_t>(f.count[i] - f.rests[i]);
         }},
    };
    return all;
}

/// Every second bin as it was in the frame before.
GasSink late_bins(GasSink next) {
    auto previous = std::make_shared<std::vector<std::uint16_t>>();
    return [=](const GasFrame& frame) {
        KeptGas kept(frame);
        for (std::size_t i = 0; i < previous->size(); ++i) {
            if (i / frame.replicas % 2 == 1) kept.count[i] = (*previous)[i];
        }
        previous->assign(frame.count.begin(), frame.count.end());
        next(kept.frame());
    };
}

bool is_middle(const GasFrame& frame, const scene::GasSampling& sampling) {
    return (frame.step - sampling.burn_in) / sampling.every == sampling.frames() / 2;
}

using scene::HopperFrame;
using HopperSink = FrameSinkOf<HopperFrame>;

struct KeptHopper {
    explicit KeptHopper(const HopperFrame& frame)
        : view(frame), state(frame.state.begin(), frame.state.end()),
          flow(frame.flow.begin(), frame.flow.end()) {}
    [[nodiscard]] HopperFrame frame() const {
        HopperFrame all = view;
        all.state = state, all.flow = flow;
        return all;
    }
    HopperFrame view;
    std::vector<std::uint8_t> state;
    std::vector<std::uint32_t> flow;
};

using SpoilHopper = std::function<void(KeptHopper&)>;

const std::map<std::string, SpoilHopper>& hopper_spoils() {
    static const std::map<std::string, SpoilHopper> all{
        {"late-flow",
         [](KeptHopper& f) {
             if (!f.flow.empty()) f.flow.pop_back();
         }},
        {"mirrored-state",
         [](KeptHopper& f) {
             for (const auto& level : f.view.levels) {
                 const auto first = f.state.begin() + static_cast<std::ptrdiff_t>(level.offset);
                 std::reverse(first, first + static_cast<std::ptrdiff_t>(level.sites()));
             }
         }},
        {"hidden-orientation",
         [](KeptHopper& f) {
             for (auto& site : f.state)
                 site = site == 0 ? std::uint8_t{0} : std::uint8_t{1};
         }},
        {"lost-grain",
         [](KeptHopper& f) {
             const auto grain = std::ranges::find_if(f.state, [](auto site) { return site != 0; });
             if (f.view.last && grain != f.state.end()) *grain = 0;
         }},
    };
    return all;
}

}  // namespace

GasSink frame_filter(const std::string& name, const scene::GasSampling& sampling, GasSink next,
                     const std::string& place) {
    if (const auto found = gas_spoils().find(name); found != gas_spoils().end()) {
        return [spoil = found->second, next = std::move(next)](const GasFrame& frame) {
            KeptGas kept(frame);
            spoil(kept);
            next(kept.frame());
        };
    }
    if (name == "late-bins") return late_bins(std::move(next));
    if (name == "duplicated-frame") {
        return [&sampling, next = std::move(next)](const GasFrame& frame) {
            next(frame);
            if (is_middle(frame, sampling)) next(frame);
        };
    }
    if (name == "lost-frame") {
        return [&sampling, next = std::move(next)](const GasFrame& frame) {
            if (!is_middle(frame, sampling)) next(frame);
        };
    }
    if (name == "truncated") {
        return [&sampling, next = std::move(next)](const GasFrame& frame) {
            if (frame.step < sampling.burn_in + sampling.steps) next(frame);
        };
    }
    throw unknown(name, "a lattice gas", place);
}

HopperSink frame_filter(const std::string& name, const scene::HopperAutomaton& scene,
                        HopperSink next, const std::string& place) {
    if (const auto found = hopper_spoils().find(name); found != hopper_spoils().end()) {
        return [spoil = found->second, next = std::move(next)](const HopperFrame& frame) {
            KeptHopper kept(frame);
            spoil(kept);
            next(kept.frame());
        };
    }
    if (name == "lost-frame") {
        return [&scene, next = std::move(next)](const HopperFrame& frame) {
            if (frame.iteration / scene.every != scene.iterations / scene.every / 2) next(frame);
        };
    }
    if (name == "truncated") {
        return [next = std::move(next)](const HopperFrame& frame) {
            if (!frame.last) next(frame);
        };
    }
    throw unknown(name, "a hopper", place);
}

}  // namespace crossgrain::selftest
