// The available memory as computed from files of /proc and /sys in the forms that systems have; larger requests are
// refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "relief/errors.h"
#include "relief/image.h"
#include "relief/memory.h"
#include "resource_limit.h"

namespace relief::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMega = std::uint64_t{1} << 20U;

// A folder that takes the place of "/".
class Root {
  public:
    Root() : folder_(fs::path(testing::TempDir()) / "memory_root") { fs::remove_all(folder_); }
    ~Root() { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
    }
    void machine(std::uint64_t mega) const {
        write("proc/meminfo", "MemTotal:       99999999 kB\nMemFree:  1 kB\nMemAvailable:   " +
                                  std::to_string(mega * 1024) + " kB\nBuffers:  7 kB\n");
    }
    std::uint64_t mega() const { return availableMemory(folder_.string()) / kMega; }
    std::uint64_t bytes() const { return availableMemory(folder_.string()); }

  private:
    fs::path folder_;
};

TEST(Memory, productsAndSumsDoNotWrap) {
    constexpr std::uint64_t kHalf = std::uint64_t{1} << 63U;
    EXPECT_EQ(byteProduct({32768, 32768, 40}), std::uint64_t{42949672960});
    EXPECT_EQ(byteProduct({kHalf, 2}), kEndlessBytes);
    EXPECT_EQ(byteProduct({kEndlessBytes, 1}), kEndlessBytes);
    EXPECT_EQ(byteSum({kHalf, kHalf - 1}), kEndlessBytes);
    EXPECT_EQ(byteSum({kHalf, kHalf}), kEndlessBytes);
    EXPECT_EQ(byteSum({3, 4}), 7U);
}

TEST(Memory, nothingKnownIsEndless) {
    EXPECT_EQ(Root().bytes(), kEndlessBytes);
}

TEST(Memory, ofTheMachine) {
    const Root root;
    root.machine(3000);
    EXPECT_EQ(root.mega(), 3000U);
}

// The limit of a parent group counts as well; the inactive file cache and half of the active one do not count as
// used.
TEST(Memory, groupsOfVersion2) {
    const Root root;
    root.machine(3000);
    root.write("proc/self/cgroup", "0::/user/job\n");
    root.write("sys/fs/cgroup/user/job/memory.max", "max\n");
    root.write("sys/fs/cgroup/user/job/memory.current", "5\n");
    EXPECT_EQ(root.mega(), 3000U);
    root.write("sys/fs/cgroup/user/memory.max", std::to_string(2000 * kMega) + "\n");
    root.write("sys/fs/cgroup/user/memory.current", std::to_string(1500 * kMega) + "\n");
    EXPECT_EQ(root.mega(), 500U);
    root.write("sys/fs/cgroup/user/memory.stat", "anon 77\ninactive_file " + std::to_string(300 * kMega) +
                                                     "\nactive_file " + std::to_string(200 * kMega) + "\n");
    EXPECT_EQ(root.mega(), 900U);
    root.write("sys/fs/cgroup/user/job/memory.max", "4\n");
    EXPECT_EQ(root.bytes(), 0U);
}

// Also next to version 2, and in a container, which shows its own group at the top instead of the host's path.
TEST(Memory, groupsOfVersion1) {
    const Root root;
    root.machine(3000);
    root.write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/abc\n0::/\n");
    root.write("sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(1000 * kMega) + "\n");
    root.write("sys/fs/cgroup/memory/memory.usage_in_bytes", std::to_string(400 * kMega) + "\n");
    root.write("sys/fs/cgroup/memory/memory.stat",
               "inactive_file 1\ntotal_inactive_file " + std::to_string(100 * kMega) + "\n");
    EXPECT_EQ(root.mega(), 700U);
    root.write("sys/fs/cgroup/memory/docker/abc/memory.limit_in_bytes", "9223372036854771712\n");
    root.write("sys/fs/cgroup/memory/docker/abc/memory.usage_in_bytes", "1\n");
    EXPECT_EQ(root.mega(), 700U);
}

TEST(Memory, limitsOfTheProcess) {
    const Root root;
    root.machine(3000);
    const auto limits = [&](const std::string& space, const std::string& data) {
        root.write("proc/self/limits",
                   "Limit                     Soft Limit           Hard Limit           Units\n"
                   "Max data size             " +
                       data +
                       "            unlimited      bytes\n"
                       "Max address space         " +
                       space + "           unlimited      bytes\n");
    };
    root.write("proc/self/status", "Name:\trelief\nVmPeak:\t  900000 kB\nVmSize:\t  102400 kB\nVmData:\t   51200 kB\n");
    limits("unlimited", "unlimited");
    EXPECT_EQ(root.mega(), 3000U);
    limits(std::to_string(500 * kMega), "unlimited");
    EXPECT_EQ(root.mega(), 400U);
    limits(std::to_string(500 * kMega), std::to_string(200 * kMega));
    EXPECT_EQ(root.mega(), 150U);
    limits("1000", "unlimited");
    EXPECT_EQ(root.bytes(), 0U);
}

TEST(Memory, theLineSaysWhatIsNeededAndWhatIsFree) {
    requireMemory(kCheckedBytes - 1, "little");
    try {
        requireMemory(kEndlessBytes, "--size 32768x32768", MemoryHint::SmallerSize);
        ADD_FAILURE() << "was not refused";
    } catch (const MemoryError& error) {
        const std::string text = error.what();
        EXPECT_TRUE(text.starts_with("--size 32768x32768: 1.84e+10 GB of memory are needed, ")) << text;
        EXPECT_NE(text.find(" GB are free"), std::string::npos) << text;
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // the sanitizers reserve terabytes
TEST(Memory, aPictureBeyondTheLimitIsRefused) {
    // More than any test process has mapped, less than the picture needs.
    const ResourceLimit limit(RLIMIT_AS, rlim_t{16} << 30U);
    EXPECT_THROW(Image<glm::dvec3>(32768, 32768), MemoryError);
}
#endif

}  // namespace
}  // namespace relief::test
