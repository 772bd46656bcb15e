// The loop of all programs here: reads orders from stdin, lets threads make frames, prints how long
// each took.
//
//   MODE THREADS COUNT, then a camera for each of COUNT frames: the seconds of each, on one line
//   save: writes t and object of the last frame to the file FRAME, and says so
#pragma once
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sched.h>
#include <string>
#include <thread>
#include <vector>

struct Vec3 { float x, y, z; };

// A ray of column c and row r: from `eye`, along `first + c * column + r * row`.
struct Camera { Vec3 eye, first, column, row; };

// t and object of every pixel, row by row from the top.
struct Image {
  int width, height;
  size_t pixels;
  float *t;
  unsigned *object;

  Image(int width, int height) : width(width), height(height), pixels(size_t(width) * height) {
    size_t bytes = (4 * pixels + 4095) / 4096 * 4096;
    t = static_cast<float *>(aligned_alloc(4096, bytes));
    object = static_cast<unsigned *>(aligned_alloc(4096, bytes));
    memset(t, 0, bytes), memset(object, 0, bytes);
  }
};

// What a thread needs to know of the frame that all of them make.
struct Frame {
  int mode;
  Camera camera;
  int threads;
  std::atomic<int> taken; // parts of the image that a thread has taken, for those who share it so
};

// Moves a thread to a processor of its own, without pinning it there. Otherwise, Linux may start all
// threads on one processor, and take tens of milliseconds to distribute them.
static inline void part(int thread) {
#if defined __linux__
  cpu_set_t all, one;
  sched_getaffinity(0, sizeof all, &all);
  int cpu = 0;
  for (int skipped = thread % CPU_COUNT(&all); !CPU_ISSET(cpu, &all) || skipped--;) cpu++;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  sched_setaffinity(0, sizeof one, &one);
  sched_setaffinity(0, sizeof all, &all);
#else
  (void)thread;
#endif
}

// Obeys orders until there are none. work(frame, thread) makes one thread's share of a frame.
template <class Work> int serve(const Image &image, const char *saved, Work work) {
  char order[64];
  while (fgets(order, sizeof order, stdin)) {
    Frame frame{};
    int count;
    if (!strcmp(order, "save\n")) {
      FILE *file = fopen(saved, "wb");
      bool whole = file && fwrite(image.t, 4, image.pixels, file) == image.pixels
        && fwrite(image.object, 4, image.pixels, file) == image.pixels;
      if (!whole || fclose(file)) return perror(saved), 1;
      puts("saved");
    } else if (sscanf(order, "%d %d %d", &frame.mode, &frame.threads, &count) == 3) {
      std::vector<Camera> cameras(count);
      for (Camera &camera : cameras) {
        for (int k = 0; k < 12; k++)
          if (scanf("%f", &camera.eye.x + k) != 1) return fprintf(stderr, "a camera is missing\n"), 1;
        getchar(); // the end of the line
      }
      std::vector<double> seconds(count);
      std::atomic<int> arrivals{0};
      auto meet = [&](int times) {
        arrivals++;
        // A thread that yields at once may get the processor back only milliseconds later.
        for (int looks = 0; arrivals < times * frame.threads; looks++)
          if (looks > 20000) sched_yield();
      };
      auto run = [&](int thread) {
        if (frame.threads > 1) part(thread);
        for (int k = 0; k < count; k++) {
          if (thread == 0) frame.camera = cameras[k], frame.taken = 0;
          auto start = std::chrono::steady_clock::now();
          meet(2 * k + 1);
          work(frame, thread);
          meet(2 * k + 2);
          std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
          if (thread == 0) seconds[k] = taken.count();
        }
      };
      std::vector<std::thread> others;
      for (int thread = 1; thread < frame.threads; thread++) others.emplace_back(run, thread);
      run(0);
      for (std::thread &other : others) other.join();
      for (double taken : seconds) printf("%.9f ", taken);
      puts("");
    } else {
      return fprintf(stderr, "no such order: %s", order), 1;
    }
    fflush(stdout);
  }
  return 0;
}
