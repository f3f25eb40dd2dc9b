// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/model_transfer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

template <typename T>
constexpr bool kIsPlain = std::is_trivially_copyable_v<T>;

[[noreturn]] void Refuse(const char* what) {
  throw Error(std::string("the imported model is damaged: ") + what);
}

class Writer {
 public:
  template <typename T>
  requires kIsPlain<T>
  void Put(const T& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  template <typename T>
  requires kIsPlain<T>
  void Put(const std::vector<T>& values) { PutArray(values.data(), values.size()); }
  void Put(const std::string& text) { PutArray(text.data(), text.size()); }
  void Put(const Bytes& file) {
    Put(file != nullptr);
    if (file) Put(*file);
  }
  void Put(const Image<Rgba8>& image) {
    Put(image.width());
    Put(image.height());
    PutArray(image.data(), image.size());
  }
  std::string Take() && { return std::move(bytes_); }

 private:
  template <typename T>
  void PutArray(const T* values, std::size_t count) {
    Put(std::uint64_t(count));
    bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }

  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  requires kIsPlain<T>
  void Get(T& value) { std::memcpy(&value, Take(sizeof value), sizeof value); }
  // A byte that is neither 0 nor 1 is no bool.
  void Get(bool& value) {
    unsigned char byte = 0;
    Get(byte);
    if (byte > 1) Refuse("a flag");
    value = byte == 1;
  }
  template <typename T>
  requires kIsPlain<T>
  void Get(std::vector<T>& values) {
    values.resize(Count(sizeof(T)));
    CopyTo(values.data(), values.size());
  }
  void Get(std::string& text) {
    text.resize(Count(1));
    CopyTo(text.data(), text.size());
  }
  void Get(Bytes& file) {
    bool present = false;
    Get(present);
    if (!present) return;
    std::string contents;
    Get(contents);
    file = std::make_shared<const std::string>(std::move(contents));
  }
  void Get(Image<Rgba8>& image) {
    std::int32_t width = 0, height = 0;
    Get(width);
    Get(height);
    const std::size_t count = Count(sizeof(Rgba8));
    constexpr std::int32_t kLargest = 1 << 15;
    if (width < 0 || height < 0 || width > kLargest || height > kLargest ||
        std::size_t(width) * std::size_t(height) != count) {
      Refuse("a picture's size");
    }
    image = Image<Rgba8>(width, height);
    CopyTo(image.data(), count);
  }
  // A number of things that take at least `least` bytes each.
  std::size_t Count(std::size_t least) {
    std::uint64_t count = 0;
    Get(count);
    if (count > rest_.size() / least) Refuse("its end is missing");
    return std::size_t(count);
  }
  void ExpectEnd() const {
    if (!rest_.empty()) Refuse("something follows it");
  }

 private:
  const char* Take(std::size_t size) {
    if (size > rest_.size()) Refuse("its end is missing");
    const char* const at = rest_.data();
    rest_.remove_prefix(size);
    return at;
  }
  template <typename T>
  void CopyTo(T* values, std::size_t count) {
    const char* const from = Take(count * sizeof(T));
    if (count > 0) std::memcpy(static_cast<void*>(values), from, count * sizeof(T));
  }

  std::string_view rest_;
};

// What a struct consists of, in both directions: visit(all its members). A member that is added to
// a struct and not here fails to compile.
template <typename Visit>
void VisitMembers(auto& m, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(m)>>, Mesh> {
  auto& [positions, normals, texcoords, triangles] = m;
  visit(positions, normals, texcoords, triangles);
}
template <typename Visit>
void VisitMembers(auto& m, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(m)>>, ModelMaterial> {
  auto& [surface, invisible] = m;
  auto& [name, diffuse, texture, emission, cutout, two_sided, specular, metallic, roughness,
         mirror] = surface;
  visit(name, diffuse, texture, emission, cutout, two_sided, specular, metallic, roughness, mirror,
        invisible);
}
template <typename Visit>
void VisitMembers(auto& m, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(m)>>, EncodedPicture> {
  auto& [place, colour, texels, opacity_place, opacity] = m;
  visit(place, colour, texels, opacity_place, opacity);
}

template <typename T>
void PutStruct(Writer& writer, const T& value) {
  VisitMembers(value, [&](const auto&... members) { (writer.Put(members), ...); });
}
template <typename T>
void GetStruct(Reader& reader, T& value) {
  VisitMembers(value, [&](auto&... members) { (reader.Get(members), ...); });
}

template <typename T>
void PutStructs(Writer& writer, const std::vector<T>& values) {
  writer.Put(std::uint64_t(values.size()));
  for (const T& value : values) PutStruct(writer, value);
}
template <typename T>
void GetStructs(Reader& reader, std::vector<T>& values) {
  values.resize(reader.Count(1));
  for (T& value : values) GetStruct(reader, value);
}

bool IsFinite(const Vec3f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void ValidateMesh(const Mesh& mesh, std::size_t material_count) {
  const std::size_t vertices = mesh.positions.size();
  if (mesh.normals.size() != vertices || mesh.texcoords.size() != vertices) {
    Refuse("the number of its normals or texture coordinates");
  }
  for (const Triangle& t : mesh.triangles) {
    if (t.material >= material_count) Refuse("a triangle's material");
    for (const std::uint32_t v : t.vertex) {
      if (v >= vertices) Refuse("a triangle's vertex");
      const Vec2f& at = mesh.texcoords[v];
      if (!IsFinite(mesh.positions[v]) || !IsFinite(mesh.normals[v]) || !std::isfinite(at.x) ||
          !std::isfinite(at.y)) {
        Refuse("a vertex that is not finite");
      }
    }
  }
}

void Validate(const Model& model) {
  ValidateMesh(model.mesh, model.materials.size());
  for (const ModelMaterial& m : model.materials) {
    if (m.surface.texture < -1 || m.surface.texture >= int(model.pictures.size())) {
      Refuse("a material's picture");
    }
    if (!IsFinite(m.surface.diffuse) || !IsFinite(m.surface.emission)) {
      Refuse("a colour that is not finite");
    }
  }
}

}  // namespace

std::string ModelToBytes(const Model& model) {
  const auto& [mesh, materials, pictures, picture_replaces_diffuse, warnings] = model;
  Writer writer;
  PutStruct(writer, mesh);
  PutStructs(writer, materials);
  PutStructs(writer, pictures);
  writer.Put(picture_replaces_diffuse);
  writer.Put(std::uint64_t(warnings.size()));
  for (const std::string& warning : warnings) writer.Put(warning);
  return std::move(writer).Take();
}

Model ModelFromBytes(std::string_view bytes) {
  Reader reader(bytes);
  Model model;
  GetStruct(reader, model.mesh);
  GetStructs(reader, model.materials);
  GetStructs(reader, model.pictures);
  reader.Get(model.picture_replaces_diffuse);
  model.warnings.resize(reader.Count(1));
  for (std::string& warning : model.warnings) reader.Get(warning);
  reader.ExpectEnd();
  Validate(model);
  return model;
}

}  // namespace silt::sim
