// A shipped reading runs as compiled code: an edit of its file that the compiled table does not
// follow would go on with the right bits, but many times slower, and nobody would notice.
#include "adapters/native/gas_model.hpp"
#include "cases/scene/gas_reading_file.hpp"
#include "native/lga/ensemble.hpp"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <string>

using namespace crossgrain;

namespace {

scene::LatticeGas gas(const std::string& reading) {
    scene::LatticeGas s;
    s.reading = scene::load_gas_reading(std::string(CROSSGRAIN_SOURCE_DIR) +
                                        "/cases/catalog/readings/" + reading + ".toml");
    s.sampling.length = 10;
    s.sampling.width = 7;
    s.sampling.bin = 10;
    s.sampling.replicas = 64;
    s.density = 1;
    s.dissipation = 0.3;
    return s;
}

bool runs_as_code(const scene::LatticeGas& scene) {
    return lga::make_sliced_ensemble(adapters::gas_model(scene), lga::word_widths().back())
        ->is_compiled();
}

}  // namespace

BOOST_AUTO_TEST_CASE(shipped_readings_run_as_code_and_an_edited_one_does_not) {
    if (lga::word_widths().back() == 64) return;  // no wide words: everything is interpreted
    for (const std::string reading : {"P", "D", "M", "std"}) {
        BOOST_TEST_CONTEXT("reading " << reading) {
            BOOST_TEST(runs_as_code(gas(reading)));
        }
    }
    auto edited = gas("P");
    edited.reading.rows.pop_back();
    BOOST_TEST(!runs_as_code(edited));
}
