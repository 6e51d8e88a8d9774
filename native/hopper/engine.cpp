#include "native/hopper/engine.hpp"

#include "native/hopper/fast_engine.hpp"
#include "native/hopper/plain_engine.hpp"

#include <utility>

namespace crossgrain::hopper {

std::unique_ptr<Engine> make_engine(const Parameters& parameters, EngineKind kind,
                                    std::shared_ptr<const CandidateTable> table) {
    if (kind == EngineKind::plain || parameters.rows == Rows::zigzag) {
        return std::make_unique<PlainEngine>(parameters);
    }
    if (!table) table = std::make_shared<CandidateTable>(integer_energies(parameters.rules));
    return std::make_unique<FastEngine>(parameters, std::move(table));
}

}  // namespace crossgrain::hopper
