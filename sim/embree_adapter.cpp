// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/embree_adapter.h"

#include <cmath>
#include <cstring>
#include <ctime>
#include <string>

#include "silt/core/error.h"

#if SILT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace silt::sim {

namespace {

// The one place where the two versions differ: 3 takes a context by pointer, 4 optional arguments.
#if SILT_EMBREE_MAJOR >= 4
void CallIntersect(RTCScene scene, const int* valid, RTCRayHit16* rays, bool coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, rays, &arguments);
}
void CallOccluded(RTCScene scene, const int* valid, RTCRay16* rays) {
  rtcOccluded16(valid, scene, rays, nullptr);
}
#else
void CallIntersect(RTCScene scene, const int* valid, RTCRayHit16* rays, bool coherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, rays);
}
void CallOccluded(RTCScene scene, const int* valid, RTCRay16* rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, scene, &context, rays);
}
#endif

void FillRays(const RayPacket& in, RTCRay16& out) {
  constexpr std::size_t bytes = sizeof(in.near);
  std::memcpy(out.org_x, in.origin_x, bytes);
  std::memcpy(out.org_y, in.origin_y, bytes);
  std::memcpy(out.org_z, in.origin_z, bytes);
  std::memcpy(out.dir_x, in.direction_x, bytes);
  std::memcpy(out.dir_y, in.direction_y, bytes);
  std::memcpy(out.dir_z, in.direction_z, bytes);
  for (int i = 0; i < kPacketSize; ++i) {
    // Where 16 rays are more than the processor's registers hold, Embree goes by the bounds alone:
    // a lane without a ray has an empty stretch, whatever it holds.
    out.tnear[i] = in.valid[i] != 0 ? in.near[i] : 0;
    out.tfar[i] = in.valid[i] != 0 ? in.far[i] : -1;
    out.time[i] = 0;
    out.mask[i] = 0xffffffffu;
    out.id[i] = 0;
    out.flags[i] = 0;
  }
}

void PrepareQuery(const RayPacket& rays, RTCRayHit16& query) {
  FillRays(rays, query.ray);
  for (int i = 0; i < kPacketSize; ++i) {
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

double ThreadSeconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Embree calls back for each packet that meets a set with a filter.
void RejectAbsent(const RTCFilterFunctionNArguments* args) {
  const auto& set = *static_cast<const TriangleSet*>(args->geometryUserPtr);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const std::uint32_t number = set.numbers[RTCHitN_primID(args->hit, args->N, i)];
    if (!set.filter(number, RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i))) {
      args->valid[i] = 0;
    }
  }
}

}  // namespace

struct EmbreeAdapter::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<TriangleSet> sets;  // by geometry id

  ~State() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void Check() const {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw Error("Embree refused the scene's triangles (error " + std::to_string(int(error)) +
                "): not enough memory?");
  }

  void Attach(const std::vector<Vec3f>& positions, TriangleSet& set) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3f), positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(set.vertices[0]), set.vertices.size());
    Check();
    std::memcpy(vertices, positions.data(), positions.size() * sizeof(Vec3f));
    std::memcpy(indices, set.vertices.data(), set.vertices.size() * sizeof(set.vertices[0]));
    if (set.filter) {
      rtcSetGeometryUserData(geometry, &set);
      rtcSetGeometryIntersectFilterFunction(geometry, RejectAbsent);
      rtcSetGeometryOccludedFilterFunction(geometry, RejectAbsent);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

EmbreeAdapter::EmbreeAdapter(const std::vector<Vec3f>& positions, std::vector<TriangleSet> sets)
    : state_(std::make_unique<State>()) {
  state_->device = rtcNewDevice(nullptr);
  if (!state_->device) throw Error("Embree does not start on this processor");
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips between two triangles
  for (TriangleSet& set : sets) {
    if (!set.vertices.empty()) state_->sets.push_back(std::move(set));
  }
  for (TriangleSet& set : state_->sets) state_->Attach(positions, set);
  rtcCommitScene(state_->scene);
  state_->Check();
}

EmbreeAdapter::~EmbreeAdapter() = default;

void EmbreeAdapter::Intersect(const RayPacket& rays, bool coherent, HitPacket& hits) const {
  RTCRayHit16 query;
  PrepareQuery(rays, query);
  CallIntersect(state_->scene, rays.valid, &query, coherent);
  for (int i = 0; i < kPacketSize; ++i) {
    const RTCHit16& hit = query.hit;
    const float nx = hit.Ng_x[i], ny = hit.Ng_y[i], nz = hit.Ng_z[i];
    const float dx = rays.direction_x[i], dy = rays.direction_y[i], dz = rays.direction_z[i];
    hits.distance[i] = query.ray.tfar[i];
    hits.u[i] = hit.u[i];
    hits.v[i] = hit.v[i];
    hits.cosine[i] = (nx * dx + ny * dy + nz * dz) /
                     std::sqrt((nx * nx + ny * ny + nz * nz) * (dx * dx + dy * dy + dz * dz));
  }
  for (int i = 0; i < kPacketSize; ++i) {
    const bool missed = rays.valid[i] == 0 || query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID;
    hits.triangle[i] =
        missed ? kNoTriangle : state_->sets[query.hit.geomID[i]].numbers[query.hit.primID[i]];
  }
}

std::uint32_t EmbreeAdapter::Occluded(const RayPacket& rays) const {
  RTCRay16 query;
  FillRays(rays, query);
  CallOccluded(state_->scene, rays.valid, &query);
  std::uint32_t bits = 0;
  for (int i = 0; i < kPacketSize; ++i) {
    // Embree marks an occluded ray with a far end of −∞.
    if (rays.valid[i] != 0 && query.tfar[i] < 0) bits |= 1u << i;
  }
  return bits;
}

double EmbreeAdapter::TimeIntersect(const std::vector<RayPacket>& packets) const {
  std::vector<RTCRayHit16> queries(packets.size());
  for (std::size_t i = 0; i < packets.size(); ++i) PrepareQuery(packets[i], queries[i]);
  const double begin_s = ThreadSeconds();
  for (std::size_t i = 0; i < packets.size(); ++i) {
    CallIntersect(state_->scene, packets[i].valid, &queries[i], true);
  }
  return ThreadSeconds() - begin_s;
}

const char* EmbreeAdapter::Version() { return RTC_VERSION_STRING; }

}  // namespace silt::sim
