// Any law, scheme and contacts, grain after grain in double precision.
#include "native/dem/force_field.hpp"
#include "native/dem/kernel.hpp"
#include "native/dem/law_choice.hpp"
#include "native/dem/motion.hpp"
#include "native/dem/scheme_choice.hpp"

#include <utility>
#include <variant>

namespace crossgrain::dem {
namespace {

class ScalarKernel final : public StepKernel {
  public:
    ScalarKernel(const Parameters& parameters, State initial);

    void advance(std::int64_t steps) override;
    const State& state() override;
    [[nodiscard]] MissedContacts missed_contacts() const override {
        return field_.missed_contacts();
    }
    [[nodiscard]] Effort effort() const override {
        return {.kernel = "scalar",
                .force_evaluations = field_.evaluations(),
                .neighbour_builds = field_.neighbour_builds(),
                .skin = field_.skin()};
    }

  private:
    [[nodiscard]] double time() const {
        return static_cast<double>(state_.step) * field_.parameters().dt;
    }

    State state_;
    ForceField field_;
    Law law_;
    AnyScheme scheme_;
    Motion motion_;
};

State with_frozen_at_rest(State s) {
    for (const std::size_t i : s.frozen)
        s.vx[i] = s.vy[i] = 0;
    return s;
}

ScalarKernel::ScalarKernel(const Parameters& parameters, State initial)
    : state_(with_frozen_at_rest(std::move(initial))), field_(parameters, state_),
      law_(law_of(parameters)), scheme_(scheme_of(parameters)), motion_(motion_of(state_)) {
    field_.look_for_missed_contacts(motion_.q, time());
    std::visit(
        [&](const auto& law, auto& scheme) {
            LawfulSystem system(field_, law);
            scheme.start(system, motion_, time());
        },
        law_, scheme_);
}

void ScalarKernel::advance(std::int64_t steps) {
    const double dt = field_.parameters().dt;
    std::visit(
        [&]<class PairLaw, IntegrationScheme<LawfulSystem<PairLaw>> TheScheme>(const PairLaw& law,
                                                                               TheScheme& scheme) {
            LawfulSystem<PairLaw> system(field_, law);
            for (std::int64_t i = 0; i < steps; ++i) {
                const double start = time();
                ++state_.step;
                scheme.step(system, motion_, {.start = start, .end = time(), .dt = dt});
                field_.look_for_missed_contacts(motion_.q, time());
            }
        },
        law_, scheme_);
}

const State& ScalarKernel::state() {
    copy_motion(motion_, state_);
    return state_;
}

}  // namespace

std::unique_ptr<StepKernel> make_scalar_kernel(const Parameters& parameters, State state) {
    return std::make_unique<ScalarKernel>(parameters, std::move(state));
}

}  // namespace crossgrain::dem
