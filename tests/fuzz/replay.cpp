#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

/// The files of `corpus` and its folders, by name, so that the order is the same in each run.
std::vector<fs::path> inputs_in(const fs::path& corpus) {
  std::error_code unreadable;
  std::vector<fs::path> inputs;
  for (const auto& entry : fs::recursive_directory_iterator(corpus, unreadable))
    if (entry.is_regular_file()) inputs.push_back(entry.path());
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

void feed(const fs::path& input) {
  std::printf("%s\n", input.c_str());  // printed first, so that the last line names the input that aborts
  std::fflush(stdout);
  std::ifstream file(input, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  // A copy of exactly the input's size. With a string's closing zero behind it, a read of one byte too many would not
  // be found.
  const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

}  // namespace

/// `replay CORPUS`: runs the fuzz target that is linked to this file on each file of the folder, without libFuzzer. So
/// inputs that fuzzing once found are tested with any compiler and sanitizer.
int main(int argc, char** argv) {
  const std::vector<fs::path> inputs = argc == 2 ? inputs_in(argv[1]) : std::vector<fs::path>{};
  if (inputs.empty()) {
    std::fprintf(stderr, "error: no inputs. fix: give one folder with at least one file\n");
    return 2;
  }
  for (const fs::path& input : inputs) feed(input);
  return 0;
}
