// A file descriptor that closes itself.
#pragma once

#include <unistd.h>

namespace fyd {

class Descriptor {
 public:
  /// @param number below zero: none
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace fyd
