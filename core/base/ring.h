// Single-producer single-consumer queue for sampled streams between two threads.
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

namespace fyd {

/// `push` returns false when the ring is full; the producer counts what it lost.
template <class T>
using Ring = boost::lockfree::spsc_queue<T>;

}  // namespace fyd
