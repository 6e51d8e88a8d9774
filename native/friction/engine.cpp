#include "native/friction/engine.hpp"

#include "native/friction/kernel.hpp"

#include <utility>

namespace crossgrain::friction {

struct Engine::Implementation {
    std::unique_ptr<StepKernel> kernel;
};

Engine::Engine(const Parameters& parameters, State state)
    : implementation_(std::make_unique<Implementation>(
          Implementation{make_kernel(parameters, std::move(state))})) {}

Engine::~Engine() = default;

void Engine::advance(std::int64_t steps) {
    implementation_->kernel->advance(steps);
}

const State& Engine::state() const {
    return implementation_->kernel->state();
}

Effort Engine::effort() const {
    return implementation_->kernel->effort();
}

}  // namespace crossgrain::friction
