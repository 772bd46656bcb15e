// Embree over spheres, in packets of 16 rays (8 or 4 where the processor is no wider), two ways:
//
//   mode 0: its own spheres
//   mode 1: user geometry, blocks of spheres that stand together, with a test as wide as a packet
//
//   embree WIDTH HEIGHT FRAME SPHERES
//
// SPHERES: x, y, z and radius of each sphere as f32. Embree 4 or, with -DEMBREE=3, Embree 3.
#include "rig.hpp"
#include <algorithm>
#include <cmath>
#include <immintrin.h>
#if EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#define JOINED(a, b) a##b
#define JOIN(a, b) JOINED(a, b)
#if defined __AVX512F__
#define WIDTH 16
#define SQRT(x) reinterpret_cast<Floats>(_mm512_sqrt_ps(reinterpret_cast<__m512>(x)))
#elif defined __AVX__
#define WIDTH 8
#define SQRT(x) reinterpret_cast<Floats>(_mm256_sqrt_ps(reinterpret_cast<__m256>(x)))
#else
#define WIDTH 4
#define SQRT(x) reinterpret_cast<Floats>(_mm_sqrt_ps(reinterpret_cast<__m128>(x)))
#endif
using RayHits = JOIN(RTCRayHit, WIDTH);
typedef float Floats __attribute__((vector_size(4 * WIDTH)));
typedef int Ints __attribute__((vector_size(4 * WIDTH)));

struct Sphere { float x, y, z, radius; };

#ifndef BLOCK
#define BLOCK 8
#endif

// Spheres that stand together.
struct Block {
  int count;
  float x[BLOCK], y[BLOCK], z[BLOCK], radius[BLOCK];
  int object[BLOCK];
};

// Adds blocks of the spheres `from` to `to`, halved along the longer side until they fit.
static void add_blocks(std::vector<Block> &blocks, const Sphere *spheres, unsigned *from, unsigned *to) {
  if (to - from <= BLOCK) {
    Block block{};
    for (; from < to; from++, block.count++) {
      const Sphere &sphere = spheres[*from];
      int k = block.count;
      block.x[k] = sphere.x, block.y[k] = sphere.y, block.z[k] = sphere.z;
      block.radius[k] = sphere.radius, block.object[k] = *from;
    }
    return blocks.push_back(block);
  }
  float widest = -1;
  int along = 0;
  for (int axis = 0; axis < 3; axis++) {
    auto less = [&](unsigned a, unsigned b) { return (&spheres[a].x)[axis] < (&spheres[b].x)[axis]; };
    auto [low, high] = std::minmax_element(from, to, less);
    float width = (&spheres[*high].x)[axis] - (&spheres[*low].x)[axis];
    if (width > widest) widest = width, along = axis;
  }
  // Whole blocks to the left.
  unsigned *middle = from + std::max<long>(BLOCK, (to - from) / 2 / BLOCK * BLOCK);
  std::nth_element(from, middle, to, [&](unsigned a, unsigned b) { return (&spheres[a].x)[along] < (&spheres[b].x)[along]; });
  add_blocks(blocks, spheres, from, middle);
  add_blocks(blocks, spheres, middle, to);
}

static void bounds_of(const RTCBoundsFunctionArguments *args) {
  const Block &block = static_cast<const Block *>(args->geometryUserPtr)[args->primID];
  RTCBounds &box = *args->bounds_o;
  box.lower_x = box.lower_y = box.lower_z = INFINITY;
  box.upper_x = box.upper_y = box.upper_z = -INFINITY;
  for (int k = 0; k < block.count; k++) {
    float x = block.x[k], y = block.y[k], z = block.z[k], radius = block.radius[k];
    box.lower_x = std::min(box.lower_x, x - radius), box.upper_x = std::max(box.upper_x, x + radius);
    box.lower_y = std::min(box.lower_y, y - radius), box.upper_y = std::max(box.upper_y, y + radius);
    box.lower_z = std::min(box.lower_z, z - radius), box.upper_z = std::max(box.upper_z, z + radius);
  }
}

// The smallest root beyond `near`, or infinity. From the point of the ray that is nearest to the
// centre: Haines, Akenine-Moeller, "Precision improvements for ray/sphere intersection" (2019).
template <class F> static inline F root(F x, F y, F z, F dx, F dy, F dz, F over_a, F radius, F near, F (*square_root)(F)) {
  F middle = (x * dx + y * dy + z * dz) * over_a;
  F px = x - middle * dx, py = y - middle * dy, pz = z - middle * dz;
  F left = (radius * radius - (px * px + py * py + pz * pz)) * over_a;
  F half = square_root(left);
  F first = middle - half, second = middle + half;
  F t = first > near ? first : second;
  return (left >= 0) & (t > near) ? t : F{} + INFINITY;
}

static inline Floats square_roots(Floats x) { return SQRT(x); }

// All rays of a packet against one sphere after the other.
static void meet_packet(const Block &block, const RTCIntersectFunctionNArguments *args) {
  RayHits &rays = *reinterpret_cast<RayHits *>(args->rayhit);
  auto floats = [](float *x) -> Floats & { return *reinterpret_cast<Floats *>(x); };
  auto ints = [](unsigned *x) -> Ints & { return *reinterpret_cast<Ints *>(x); };
  Floats x = floats(rays.ray.org_x), y = floats(rays.ray.org_y), z = floats(rays.ray.org_z);
  Floats dx = floats(rays.ray.dir_x), dy = floats(rays.ray.dir_y), dz = floats(rays.ray.dir_z);
  Floats over_a = 1 / (dx * dx + dy * dy + dz * dz), near = floats(rays.ray.tnear);
  Ints valid = *reinterpret_cast<const Ints *>(args->valid) != 0;
  Floats far = floats(rays.ray.tfar);
  Ints object = ints(rays.hit.primID), met = Ints{};
  for (int k = 0; k < block.count; k++) {
    Floats t = root(block.x[k] - x, block.y[k] - y, block.z[k] - z, dx, dy, dz, over_a, Floats{} + block.radius[k], near, square_roots);
    Ints nearer = valid & (t < far);
    far = nearer ? t : far, object = nearer ? Ints{} + block.object[k] : object, met |= nearer;
  }
  floats(rays.ray.tfar) = far, ints(rays.hit.primID) = object;
  ints(rays.hit.geomID) = met ? Ints{} + int(args->geomID) : ints(rays.hit.geomID);
}

// Rays one by one, where Embree has taken a packet apart.
static void meet_single(const Block &block, const RTCIntersectFunctionNArguments *args) {
  RTCRayN *rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN *hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; i++) {
    if (!args->valid[i]) continue;
    float x = RTCRayN_org_x(rays, args->N, i), y = RTCRayN_org_y(rays, args->N, i), z = RTCRayN_org_z(rays, args->N, i);
    float dx = RTCRayN_dir_x(rays, args->N, i), dy = RTCRayN_dir_y(rays, args->N, i), dz = RTCRayN_dir_z(rays, args->N, i);
    float over_a = 1 / (dx * dx + dy * dy + dz * dz), near = RTCRayN_tnear(rays, args->N, i);
    float &far = RTCRayN_tfar(rays, args->N, i);
    float ts[BLOCK];
    for (int k = 0; k < BLOCK; k++)
      ts[k] = root<float>(block.x[k] - x, block.y[k] - y, block.z[k] - z, dx, dy, dz, over_a, block.radius[k], near, sqrtf);
    for (int k = 0; k < block.count; k++)
      if (ts[k] < far)
        far = ts[k], RTCHitN_primID(hits, args->N, i) = block.object[k], RTCHitN_geomID(hits, args->N, i) = args->geomID;
  }
}

static long singles, packets;
static void intersect(const RTCIntersectFunctionNArguments *args) {
  const Block &block = static_cast<const Block *>(args->geometryUserPtr)[args->primID];
  if (args->N == WIDTH) packets++; else singles++;
  args->N == WIDTH ? meet_packet(block, args) : meet_single(block, args);
}

static RTCScene scene_of(RTCDevice device, RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, geometry);
  rtcCommitScene(scene);
  return scene;
}

static RTCScene own_spheres(RTCDevice device, const std::vector<Sphere> &spheres) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  void *buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(Sphere), spheres.size());
  memcpy(buffer, spheres.data(), spheres.size() * sizeof(Sphere));
  return scene_of(device, geometry);
}

static RTCScene user_geometry(RTCDevice device, std::vector<Block> &blocks) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, blocks.size());
  rtcSetGeometryUserData(geometry, blocks.data());
  rtcSetGeometryBoundsFunction(geometry, [](const RTCBoundsFunctionArguments *args) { bounds_of(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  return scene_of(device, geometry);
}

// A packet's pixels.
#ifndef ACROSS
#define ACROSS 4
#endif
constexpr int DOWN = WIDTH / ACROSS;

// One packet, from the pixel at its upper left on.
static void trace(RTCScene scene, const Camera &camera, const Image &image, int column, int row) {
  alignas(64) RayHits rays;
  alignas(64) int valid[WIDTH];
  for (int k = 0; k < WIDTH; k++) {
    int c = column + k % ACROSS, r = row + k / ACROSS;
    valid[k] = c < image.width && r < image.height ? -1 : 0;
    rays.ray.org_x[k] = camera.eye.x, rays.ray.org_y[k] = camera.eye.y, rays.ray.org_z[k] = camera.eye.z;
    rays.ray.dir_x[k] = camera.first.x + c * camera.column.x + r * camera.row.x;
    rays.ray.dir_y[k] = camera.first.y + c * camera.column.y + r * camera.row.y;
    rays.ray.dir_z[k] = camera.first.z + c * camera.column.z + r * camera.row.z;
    rays.ray.tnear[k] = 0, rays.ray.tfar[k] = INFINITY, rays.ray.time[k] = 0;
    rays.ray.mask[k] = -1, rays.ray.id[k] = k, rays.ray.flags[k] = 0;
    rays.hit.geomID[k] = rays.hit.primID[k] = rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
#if EMBREE == 3
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  JOIN(rtcIntersect, WIDTH)(valid, scene, &context, &rays);
#else
  RTCIntersectArguments args;
  rtcInitIntersectArguments(&args);
  args.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  JOIN(rtcIntersect, WIDTH)(valid, scene, &rays, &args);
#endif
  int columns = std::min(ACROSS, image.width - column), rows = std::min(DOWN, image.height - row);
  for (int k = 0; k < rows; k++) {
    size_t pixel = size_t(row + k) * image.width + column;
    memcpy(image.t + pixel, rays.ray.tfar + k * ACROSS, 4 * columns);
    memcpy(image.object + pixel, rays.hit.primID + k * ACROSS, 4 * columns);
  }
}

int main(int, char **words) {
  Image image(atoi(words[1]), atoi(words[2]));
  FILE *file = fopen(words[4], "rb");
  if (!file) return perror(words[4]), 1;
  std::vector<Sphere> spheres;
  for (Sphere sphere; fread(&sphere, sizeof sphere, 1, file) == 1;) spheres.push_back(sphere);
  std::vector<unsigned> order(spheres.size());
  for (unsigned k = 0; k < order.size(); k++) order[k] = k;
  std::vector<Block> blocks;
  add_blocks(blocks, spheres.data(), order.data(), order.data() + order.size());
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scenes[] = {own_spheres(device, spheres), user_geometry(device, blocks)};
  // Bands of whole packets, taken by whoever is free.
  int bands = (image.height + DOWN - 1) / DOWN;
  return serve(image, words[3], [&](Frame &frame, int) {
    _mm_setcsr(_mm_getcsr() | 0x8040); // no subnormal numbers, as Embree advises
    for (int band; (band = frame.taken++) < bands;)
      for (int column = 0; column < image.width; column += ACROSS)
        trace(scenes[frame.mode], frame.camera, image, column, DOWN * band);
  });
}
