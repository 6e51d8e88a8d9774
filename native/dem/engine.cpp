#include "native/dem/engine.hpp"

#include "native/dem/kernel.hpp"

#include <utility>

namespace crossgrain::dem {

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

MissedContacts Engine::missed_contacts() const {
    return implementation_->kernel->missed_contacts();
}

Effort Engine::effort() const {
    return implementation_->kernel->effort();
}

}  // namespace crossgrain::dem
