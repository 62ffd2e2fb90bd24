/* Preloaded into a program: after SET_BACK_AFTER questions for the time of day, the clock goes a day
   and some more wrong. Clocks that only go on, as the system's do, stay right. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>

static const time_t kBack = 86400 + 3600;

static time_t error(void) {
  static atomic_long asked;
  const char* after = getenv("SET_BACK_AFTER");
  return after != NULL && atomic_fetch_add(&asked, 1) >= atol(after) ? kBack : 0;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  static int (*real)(clockid_t, struct timespec*);
  if (real == NULL) real = (int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime");
  const int result = real(clock, now);
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) now->tv_sec -= error();
  return result;
}

int gettimeofday(struct timeval* restrict now, void* restrict zone) {
  static int (*real)(struct timeval*, void*);
  if (real == NULL) real = (int (*)(struct timeval*, void*))dlsym(RTLD_NEXT, "gettimeofday");
  const int result = real(now, zone);
  now->tv_sec -= error();
  return result;
}

time_t time(time_t* answer) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (answer != NULL) *answer = now.tv_sec;
  return now.tv_sec;
}
