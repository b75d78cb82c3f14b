// Runs a fuzz target without a fuzzer: every file of a folder as it is, then a number of seeded changes of them.
//   fuzz_NAME CORPUS_FOLDER CHANGES
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

void change(Bytes& bytes, const std::vector<Bytes>& corpus, std::mt19937_64& random) {
  const auto at = [&] { return static_cast<std::ptrdiff_t>(random() % (bytes.size() + 1)); };
  switch (random() % 5) {
    case 0:
      if (!bytes.empty()) bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
      break;
    case 1:
      if (!bytes.empty()) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      break;
    case 2: bytes.resize(random() % (bytes.size() + 1)); break;
    case 3: bytes.insert(bytes.begin() + at(), static_cast<std::uint8_t>(random())); break;
    default: {
      const Bytes& other = corpus[random() % corpus.size()];
      bytes.insert(bytes.begin() + at(), other.begin(), other.end());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " CORPUS_FOLDER CHANGES\n";
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Bytes> corpus;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    LLVMFuzzerTestOneInput(corpus.back().data(), corpus.back().size());
  }
  if (corpus.empty()) {
    std::cerr << argv[1] << ": no files\n";
    return 1;
  }
  std::mt19937_64 random(1);
  const long changes = std::stol(argv[2]);
  for (long i = 0; i < changes; ++i) {
    Bytes bytes = corpus[random() % corpus.size()];
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) change(bytes, corpus, random);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::cout << corpus.size() << " files and " << changes << " changes of them\n";
}
