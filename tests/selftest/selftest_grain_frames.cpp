// Spoiled frames of grains.
#include "tests/selftest/selftest_frames.hpp"

#include "native/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace crossgrain::selftest {
namespace {

using scene::Frame;
using Sink = FrameSinkOf<Frame>;

/// A frame that outlives the call it came with and can be changed.
struct KeptFrame {
    explicit KeptFrame(const Frame& frame)
        : view(frame), x(frame.x.begin(), frame.x.end()), y(frame.y.begin(), frame.y.end()),
          vx(frame.vx.begin(), frame.vx.end()), vy(frame.vy.begin(), frame.vy.end()),
          omega(frame.omega.begin(), frame.omega.end()) {}
    [[nodiscard]] Frame frame() const {
        Frame all = view;
        all.x = x, all.y = y, all.vx = vx, all.vy = vy, all.omega = omega;
        return all;
    }
    Frame view;
    std::vector<double> x, y, vx, vy, omega;
};

using Spoil = std::function<void(KeptFrame&, const scene::Scene&)>;

/// Changes every frame by itself.
Sink each(Spoil spoil, const scene::Scene& scene, Sink next) {
    return [spoil = std::move(spoil), &scene, next = std::move(next)](const Frame& frame) {
        KeptFrame kept(frame);
        spoil(kept, scene);
        next(kept.frame());
    };
}

/// Changes a frame by the one before.
Sink with_previous(std::function<void(KeptFrame&, const KeptFrame&)> spoil, Sink next) {
    auto previous = std::make_shared<std::unique_ptr<KeptFrame>>();
    return [=](const Frame& frame) {
        KeptFrame kept(frame);
        auto original = std::make_unique<KeptFrame>(frame);
        if (*previous) spoil(kept, **previous);
        *previous = std::move(original);
        next(kept.frame());
    };
}

/// The frame in the middle of the run.
bool is_middle(const Frame& frame, const scene::Scene& scene) {
    const auto frames = scene.steps / scene.frame_every;
    return frame.step / scene.frame_every == frames / 2;
}

void fold(std::vector<double>& positions, const std::optional<double>& period) {
    if (!period) return;
    for (double& p : positions)
        p -= *period * std::floor(p / *period);
}

void round_to_float(std::vector<double>& values) {
    for (double& value : values)
        value = static_cast<double>(static_cast<float>(value));
}

const std::map<std::string, Spoil>& spoils() {
    static const std::map<std::string, Spoil> all{
        {"nan-in-one-frame",
         [](KeptFrame& f, const scene::Scene& s) {
             if (is_middle(f.view, s)) f.x.back() = std::numeric_limits<double>::quiet_NaN();
         }},
        {"wrapped-positions",
         [](KeptFrame& f, const scene::Scene& s) {
             fold(f.x, s.periodic_x);
             fold(f.y, s.periodic_y);
         }},
        {"swapped-axes",
         [](KeptFrame& f, const scene::Scene&) {
             std::swap(f.x, f.y);
             std::swap(f.vx, f.vy);
         }},
        {"single-precision",
         [](KeptFrame& f, const scene::Scene&) {
             for (auto* values : {&f.x, &f.y, &f.vx, &f.vy})
                 round_to_float(*values);
         }},
        {"reversed-grains",
         [](KeptFrame& f, const scene::Scene&) {
             for (auto* values : {&f.x, &f.y, &f.vx, &f.vy})
                 std::ranges::reverse(*values);
         }},
        {"lid-off-by-radius",
         [](KeptFrame& f, const scene::Scene& s) {
             if (f.view.lid) f.view.lid->height += s.grains.diameter / 2;
         }},
    };
    return all;
}

}  // namespace

Sink frame_filter(const std::string& name, const scene::Scene& scene, Sink next,
                  const std::string& place) {
    if (const auto found = spoils().find(name); found != spoils().end()) {
        return each(found->second, scene, std::move(next));
    }
    if (name == "duplicated-frame") {
        return [&scene, next = std::move(next)](const Frame& frame) {
            next(frame);
            if (is_middle(frame, scene)) next(frame);
        };
    }
    if (name == "lost-frame") {
        return [&scene, next = std::move(next)](const Frame& frame) {
            if (!is_middle(frame, scene)) next(frame);
        };
    }
    if (name == "truncated") {
        return [&scene, next = std::move(next)](const Frame& frame) {
            if (frame.step < scene.steps) next(frame);
        };
    }
    if (name == "half-step-velocities") {
        return with_previous(
            [](KeptFrame& f, const KeptFrame& before) {
                for (std::size_t i = 0; i < f.vx.size(); ++i) {
                    f.vx[i] = (f.vx[i] + before.vx[i]) / 2;
                    f.vy[i] = (f.vy[i] + before.vy[i]) / 2;
                }
            },
            std::move(next));
    }
    if (name == "late-positions") {
        return with_previous(
            [](KeptFrame& f, const KeptFrame& before) {
                f.x = before.x;
                f.y = before.y;
            },
            std::move(next));
    }
    throw CaseError({.file = place,
                     .key = "defect.filter",
                     .problem = "is not known for grains",
                     .got = "\"" + name + "\"",
                     .expected = "a filter of tests/selftest/selftest_frames.hpp"});
}

}  // namespace crossgrain::selftest
