// Embree over spheres, in packets of 16 rays (8 or 4 where the processor's vectors are no wider):
//
//   mode 0: its own spheres
//   mode 1: user geometry, a sphere each, with a test of a whole packet
//   mode 2: the same, with rays that are not declared coherent: faster over a few spheres
//
//   embree WIDTH HEIGHT FRAME SPHERES
//
// SPHERES: x, y, z and radius of each sphere as f32. Leaves of 4, 8 or 16 spheres, and rays one by one
// against 16 spheres at once, are slower than mode 1 or 2 wherever there are more than three spheres.
#include "rig.hpp"
#include <algorithm>
#include <cmath>
#include <immintrin.h>
#if EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#if defined __AVX512F__
#define WIDTH 16
#define INTERSECT rtcIntersect16
using RayHits = RTCRayHit16;
#define SQRT(x) Floats(_mm512_sqrt_ps(__m512(x)))
#elif defined __AVX__
#define WIDTH 8
#define INTERSECT rtcIntersect8
using RayHits = RTCRayHit8;
#define SQRT(x) Floats(_mm256_sqrt_ps(__m256(x)))
#else
#define WIDTH 4
#define INTERSECT rtcIntersect4
using RayHits = RTCRayHit4;
#define SQRT(x) Floats(_mm_sqrt_ps(__m128(x)))
#endif
typedef float Floats __attribute__((vector_size(4 * WIDTH), may_alias));
typedef int Ints __attribute__((vector_size(4 * WIDTH), may_alias));
static inline Floats &floats(float *lanes) { return *reinterpret_cast<Floats *>(lanes); }
static inline Ints &ints(unsigned *lanes) { return *reinterpret_cast<Ints *>(lanes); }

struct Sphere { float x, y, z, radius; };

static void bounds(const RTCBoundsFunctionArguments *args) {
  auto [x, y, z, radius] = static_cast<const Sphere *>(args->geometryUserPtr)[args->primID];
  *args->bounds_o = {x - radius, y - radius, z - radius, 0, x + radius, y + radius, z + radius, 0};
}

// From the point of the ray that is nearest to the centre: Haines, Guenther, Akenine-Moeller,
// "Precision improvements for ray/sphere intersection", Ray Tracing Gems (2019).
static void intersect(const RTCIntersectFunctionNArguments *args) {
  if (args->N != WIDTH) fputs("Embree has taken a packet apart\n", stderr), abort();
  const Sphere &sphere = static_cast<const Sphere *>(args->geometryUserPtr)[args->primID];
  auto &[ray, hit] = *reinterpret_cast<RayHits *>(args->rayhit);
  Floats dx = floats(ray.dir_x), dy = floats(ray.dir_y), dz = floats(ray.dir_z);
  Floats over_a = 1 / (dx * dx + dy * dy + dz * dz);
  Floats x = sphere.x - floats(ray.org_x), y = sphere.y - floats(ray.org_y), z = sphere.z - floats(ray.org_z);
  Floats middle = (x * dx + y * dy + z * dz) * over_a;
  x -= middle * dx, y -= middle * dy, z -= middle * dz;
  Floats square = (sphere.radius * sphere.radius - (x * x + y * y + z * z)) * over_a;
  Floats half = SQRT(square), near = floats(ray.tnear), far = floats(ray.tfar);
  Floats t = middle - half > near ? middle - half : middle + half;
  Ints is_nearer = (*reinterpret_cast<const Ints *>(args->valid) != 0) & (square >= 0) & (t > near) & (t < far);
  floats(ray.tfar) = is_nearer ? t : far;
  ints(hit.primID) = is_nearer ? Ints{} + int(args->primID) : ints(hit.primID);
  ints(hit.geomID) = is_nearer ? Ints{} + int(args->geomID) : ints(hit.geomID);
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
  void *buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                         sizeof(Sphere), spheres.size());
  memcpy(buffer, spheres.data(), spheres.size() * sizeof(Sphere));
  return scene_of(device, geometry);
}

static RTCScene user_geometry(RTCDevice device, std::vector<Sphere> &spheres) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, spheres.size());
  rtcSetGeometryUserData(geometry, spheres.data());
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  return scene_of(device, geometry);
}

// A packet's pixels.
constexpr int ACROSS = 4, DOWN = WIDTH / ACROSS;

// Traces the packets of a band of DOWN rows, from its first row on.
static void trace(RTCScene scene, bool is_coherent, const Camera &camera, const Image &image, int row) {
  RayHits rays;
  auto &[ray, hit] = rays;
  Floats c, r, one = Floats{} + 1;
  for (int k = 0; k < WIDTH; k++) c[k] = k % ACROSS, r[k] = row + k / ACROSS;
  floats(ray.org_x) = camera.eye.x * one, floats(ray.org_y) = camera.eye.y * one;
  floats(ray.org_z) = camera.eye.z * one;
  floats(ray.tnear) = floats(ray.time) = Floats{};
  ints(ray.id) = ints(ray.flags) = Ints{}, ints(ray.mask) = Ints{} - 1;
#if EMBREE == 3
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (is_coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
#else
  RTCIntersectArguments context;
  rtcInitIntersectArguments(&context);
  if (is_coherent) context.flags = RTC_RAY_QUERY_FLAG_COHERENT;
#endif
  for (int column = 0; column < image.width; column += ACROSS, c += ACROSS) {
    Ints valid = (c < float(image.width)) & (r < float(image.height));
    floats(ray.dir_x) = camera.first.x + c * camera.column.x + r * camera.row.x;
    floats(ray.dir_y) = camera.first.y + c * camera.column.y + r * camera.row.y;
    floats(ray.dir_z) = camera.first.z + c * camera.column.z + r * camera.row.z;
    floats(ray.tfar) = INFINITY * one;
    ints(hit.geomID) = ints(hit.primID) = ints(hit.instID[0]) = Ints{} - 1;
#if EMBREE == 3
    INTERSECT(reinterpret_cast<int *>(&valid), scene, &context, &rays);
#else
    INTERSECT(reinterpret_cast<int *>(&valid), scene, &rays, &context);
#endif
    for (int k = 0; k < std::min(DOWN, image.height - row); k++) {
      size_t pixel = size_t(row + k) * image.width + column;
      auto copy = [&](size_t columns) {
        memcpy(image.t + pixel, ray.tfar + k * ACROSS, 4 * columns);
        memcpy(image.object + pixel, hit.primID + k * ACROSS, 4 * columns);
      };
      // A number that is known when this is compiled takes no call.
      column + ACROSS <= image.width ? copy(ACROSS) : copy(image.width - column);
    }
  }
}

int main(int, char **words) {
  Image image(atoi(words[1]), atoi(words[2]));
  FILE *file = fopen(words[4], "rb");
  if (!file) return perror(words[4]), 1;
  std::vector<Sphere> spheres;
  for (Sphere sphere; fread(&sphere, sizeof sphere, 1, file) == 1;) spheres.push_back(sphere);
  fclose(file);
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scenes[] = {own_spheres(device, spheres), user_geometry(device, spheres)};
  // Bands are taken by whoever is free.
  int bands = (image.height + DOWN - 1) / DOWN;
  return serve(image, words[3], [&](Frame &frame, int) {
    _mm_setcsr(_mm_getcsr() | 0x8040); // no subnormal numbers, as Embree advises
    for (int band; (band = frame.taken++) < bands;)
      trace(scenes[frame.mode > 0], frame.mode < 2, frame.camera, image, DOWN * band);
  });
}
