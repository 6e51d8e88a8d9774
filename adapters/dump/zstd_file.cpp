#include "adapters/dump/zstd_file.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <fstream>
#include <new>
#include <streambuf>
#include <utility>
#include <vector>

namespace crossgrain::adapters::dump {

namespace {

struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

template <class Context>
std::unique_ptr<Context, Free> owned(Context* context) {
    if (context == nullptr) throw std::bad_alloc();
    return std::unique_ptr<Context, Free>(context);
}

}  // namespace

class ZstdFile::Buffer final : public std::streambuf {
  public:
    explicit Buffer(const std::filesystem::path& file)
        : file_(file, std::ios::binary), context_(owned(ZSTD_createCCtx())),
          room_(ZSTD_CStreamOutSize()) {
        ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
    }

    [[nodiscard]] bool is_open() const { return file_.is_open(); }
    /// False if the file or an earlier write was faulty; ends the file at the first call.
    bool finish() {
        if (!file_.is_open()) return whole_;
        whole_ = compress({}, ZSTD_e_end) && whole_;
        file_.close();
        whole_ = whole_ && file_.good();
        return whole_;
    }

  protected:
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        return compress({text, static_cast<std::size_t>(size)}, ZSTD_e_continue) ? size : 0;
    }
    int_type overflow(int_type character) override {
        const char byte = traits_type::to_char_type(character);
        return compress({&byte, 1}, ZSTD_e_continue) ? character : traits_type::eof();
    }

  private:
    bool compress(std::string_view bytes, ZSTD_EndDirective how) {
        ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
        while (whole_) {
            ZSTD_outBuffer out{room_.data(), room_.size(), 0};
            const std::size_t left = ZSTD_compressStream2(context_.get(), &out, &in, how);
            whole_ = ZSTD_isError(left) == 0 &&
                     file_.write(room_.data(), static_cast<std::streamsize>(out.pos)).good();
            if (how == ZSTD_e_end ? left == 0 : in.pos == in.size) break;
        }
        return whole_;
    }

    std::ofstream file_;
    std::unique_ptr<ZSTD_CCtx, Free> context_;
    std::vector<char> room_;
    bool whole_ = true;
};

ZstdFile::ZstdFile(const std::filesystem::path& file)
    : std::ostream(nullptr), buffer_(std::make_unique<Buffer>(file)) {
    rdbuf(buffer_.get());
    if (!buffer_->is_open()) setstate(failbit);
}

ZstdFile::~ZstdFile() {
    (void)buffer_->finish();
}

bool ZstdFile::finish() {
    if (!buffer_->finish()) setstate(badbit);
    return good();
}

struct ZstdUnpacker::State {
    std::function<void(std::string_view)> sink;
    std::unique_ptr<ZSTD_DCtx, Free> context = owned(ZSTD_createDCtx());
    std::vector<char> room = std::vector<char>(ZSTD_DStreamOutSize());
    std::size_t missing = 0;  ///< 0 at the end of a frame of zstd, or before the first one
};

ZstdUnpacker::ZstdUnpacker(std::function<void(std::string_view)> sink)
    : state_(std::make_unique<State>(State{.sink = std::move(sink)})) {
    constexpr int largest_window = 23;  // log2 of bytes
    ZSTD_DCtx_setParameter(state_->context.get(), ZSTD_d_windowLogMax, largest_window);
}

ZstdUnpacker::~ZstdUnpacker() = default;

void ZstdUnpacker::feed(std::string_view bytes) {
    State& s = *state_;
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    bool more = false;  // in the decoder, for which there was no room
    while (in.pos < in.size || more) {
        ZSTD_outBuffer out{s.room.data(), s.room.size(), 0};
        s.missing = ZSTD_decompressStream(s.context.get(), &out, &in);
        if (ZSTD_isError(s.missing) != 0) {
            throw TrajectoryError(
                fmt::format("compressed dump is damaged (zstd: {})", ZSTD_getErrorName(s.missing)));
        }
        more = out.pos == out.size && s.missing != 0;
        s.sink({s.room.data(), out.pos});
    }
}

void ZstdUnpacker::finish() const {
    if (state_->missing != 0) throw TrajectoryError("compressed dump is cut off");
}

}  // namespace crossgrain::adapters::dump
