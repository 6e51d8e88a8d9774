// Any bytes as the results of a stored run. What is read is written again, and must be the same.
#include "tests/fuzz/fuzz_input.hpp"

#include "adapters/run/store/results_json.hpp"
#include "native/base/bounded_json.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace crossgrain;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto results = store::results_from_json(bounded_cbor({data, size}));
        const auto written = nlohmann::json::to_cbor(store::to_json(results));
        const auto again = store::results_from_json(bounded_cbor(written));
        if (nlohmann::json::to_cbor(store::to_json(again)) != written) std::abort();
    } catch (const nlohmann::json::exception&) {  // another shape than ours
    } catch (const std::invalid_argument&) {      // damaged
    }
    return 0;
}
