// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/assimp_io.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <cstring>
#include <string_view>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

// A file in memory, shared with whoever else reads it.
class BytesStream : public Assimp::IOStream {
 public:
  explicit BytesStream(Bytes bytes) : bytes_(std::move(bytes)) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_->size() - position_) / size);
    std::memcpy(buffer, bytes_->data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  // assimp counts back from the end with a positive offset.
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t size = bytes_->size();
    std::size_t to = offset;
    if (origin == aiOrigin_CUR) to = position_ + offset;
    if (origin == aiOrigin_END) to = offset > size ? size + 1 : size - offset;
    if (to > size) return aiReturn_FAILURE;
    position_ = to;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return bytes_->size(); }
  void Flush() override {}

 private:
  Bytes bytes_;
  std::size_t position_ = 0;
};

// assimp 5.2 writes through a null pointer for properties that come before the first "newmtl" of a
// material file, so it gets to see the file from there on only. It also gives up on a model whose
// material file is nearly empty, hence the comment.
Bytes FromFirstMaterial(const Bytes& file) {
  constexpr std::string_view kKeyword = "newmtl";
  constexpr std::string_view kBlanks = " \t\r";
  const std::string_view text = *file;
  std::size_t line = 0;
  while (line < text.size()) {
    const std::size_t word = text.find_first_not_of(kBlanks, line);
    if (word != std::string_view::npos && text.substr(word).starts_with(kKeyword)) break;
    const std::size_t end = text.find('\n', line);
    line = end == std::string_view::npos ? text.size() : end + 1;
  }
  return std::make_shared<const std::string>("# materials of a model\n" +
                                             std::string(text.substr(line)) + "\n");
}

class AssimpIo : public Assimp::IOSystem {
 public:
  AssimpIo(const AssetSource& source, std::set<std::string>& missing)
      : source_(source), missing_(missing) {}

  bool Exists(const char* path) const override { return source_.Find(path).has_value(); }
  char getOsSeparator() const override { return '/'; }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strpbrk(mode, "wa+") != nullptr) return nullptr;
    const std::optional<std::string> name = source_.Find(path);
    if (!name) {
      missing_.insert(source_.Describe(NormalizedAssetPath(path)) + ": no such file");
      return nullptr;
    }
    try {
      Bytes bytes = source_.Read(*name);
      if (LowerCase(*name).ends_with(".mtl")) bytes = FromFirstMaterial(bytes);
      return new BytesStream(std::move(bytes));
    } catch (const Error& e) {
      missing_.insert(e.what());
      return nullptr;
    }
  }

 private:
  const AssetSource& source_;
  std::set<std::string>& missing_;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> MakeAssimpIo(const AssetSource& source,
                                               std::set<std::string>& missing) {
  return std::make_unique<AssimpIo>(source, missing);
}

}  // namespace silt::sim
