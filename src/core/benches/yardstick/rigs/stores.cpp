// Writes t and object of every pixel with streaming (non-temporal) stores, and does nothing else.
//
//   stores WIDTH HEIGHT FRAME
#include "rig.hpp"
#if defined __SSE2__
#include <immintrin.h>
#endif

// Fills a cache line with one value, without reading the line first.
static inline void stream(void *line, int value) {
#if defined __AVX512F__
  _mm512_stream_si512(static_cast<__m512i *>(line), _mm512_set1_epi32(value));
#elif defined __AVX__
  for (int k = 0; k < 2; k++) _mm256_stream_si256(static_cast<__m256i *>(line) + k, _mm256_set1_epi32(value));
#elif defined __SSE2__
  for (int k = 0; k < 4; k++) _mm_stream_si128(static_cast<__m128i *>(line) + k, _mm_set1_epi32(value));
#else
  for (int k = 0; k < 16; k++) __builtin_nontemporal_store(value, static_cast<int *>(line) + k);
#endif
}

int main(int, char **words) {
  Image image(atoi(words[1]), atoi(words[2]));
  size_t lines = (image.pixels + 15) / 16;
  return serve(image, words[3], [&](const Frame &frame, int thread) {
    size_t from = lines * thread / frame.threads, to = lines * (thread + 1) / frame.threads;
    for (size_t line = from; line < to; line++) {
      stream(image.t + 16 * line, int(line));
      stream(image.object + 16 * line, int(line));
    }
#if defined __SSE2__
    _mm_sfence();
#endif
  });
}
