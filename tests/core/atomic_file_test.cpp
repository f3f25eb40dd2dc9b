// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "silt/core/error.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("atomic_file_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    file_ = folder_ / "result.txt";
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string Read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  std::size_t FilesInFolder() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), {}));
  }
  static std::string ErrorOf(const std::function<void()>& write) {
    try {
      write();
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  fs::path folder_, file_;
};

// Until it goes out of scope this process cannot write files beyond `bytes`, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(AtomicFileTest, WritesEveryByteAndNothingElse) {
  const std::string bytes("a\0b\r\n\xff", 6);
  WriteFileAtomically(file_, bytes);
  EXPECT_EQ(Read(file_), bytes);
  WriteFileAtomically(file_, "second");
  EXPECT_EQ(Read(file_), "second");
  EXPECT_EQ(FilesInFolder(), 1u);
}

TEST_F(AtomicFileTest, MakesMissingFolders) {
  WriteFileAtomically(folder_ / "a" / "b" / "c.txt", "deep");
  EXPECT_EQ(Read(folder_ / "a" / "b" / "c.txt"), "deep");
}

TEST_F(AtomicFileTest, WriterGetsAPathWithTheSameExtension) {
  WriteFileAtomically(folder_ / "picture.png", [&](const fs::path& part) {
    EXPECT_EQ(part.extension(), ".png");
    EXPECT_EQ(part.parent_path(), folder_);
    EXPECT_NE(part.filename(), "picture.png");
    std::ofstream(part) << "png";
    return true;
  });
  EXPECT_EQ(Read(folder_ / "picture.png"), "png");
}

TEST_F(AtomicFileTest, FailedWriterLeavesTheOldFileAlone) {
  WriteFileAtomically(file_, "old");
  const std::string error = ErrorOf([&] {
    WriteFileAtomically(file_, [](const fs::path& part) {
      std::ofstream(part) << "half of the n";
      return false;
    });
  });
  EXPECT_THAT(error, HasSubstr(file_.string() + ": cannot be written: "));
  EXPECT_EQ(Read(file_), "old");
  EXPECT_EQ(FilesInFolder(), 1u);
}

TEST_F(AtomicFileTest, ThrowingWriterLeavesNothingBehind) {
  EXPECT_THROW(WriteFileAtomically(file_,
                                   [](const fs::path& part) -> bool {
                                     std::ofstream(part) << "half";
                                     throw std::runtime_error("encoder");
                                   }),
               std::runtime_error);
  EXPECT_EQ(FilesInFolder(), 0u);
}

TEST_F(AtomicFileTest, FullDiskLeavesTheOldFileAlone) {
  WriteFileAtomically(file_, "old");
  // The first fails in fwrite, the second, which fits its buffer, as late as in fflush.
  for (std::size_t size : {std::size_t(1) << 20, std::size_t(3000)}) {
    std::string error;
    {
      const FileSizeLimit limit(1000);
      error = ErrorOf([&] { WriteFileAtomically(file_, std::string(size, 'x')); });
    }
    EXPECT_THAT(error, AllOf(HasSubstr(file_.string()), HasSubstr("File too large")));
    EXPECT_EQ(Read(file_), "old");
    EXPECT_EQ(FilesInFolder(), 1u);
  }
}

// Nodes of the test's own: were the code wrong, the machine's /dev/null would be replaced by a
// file.
TEST_F(AtomicFileTest, PipeIsWrittenInPlace) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  std::string text;
  std::thread reader([&] { text = Read(file_); });
  WriteFileAtomically(file_, "through");
  ASSERT_TRUE(fs::is_fifo(file_));
  reader.join();
  EXPECT_EQ(text, "through");
  EXPECT_EQ(FilesInFolder(), 1u);
}

TEST_F(AtomicFileTest, FullDeviceIsWrittenInPlace) {
  if (::mknod(file_.c_str(), S_IFCHR | 0600, ::makedev(1, 7)) != 0 || !std::ofstream(file_)) {
    GTEST_SKIP() << "making a device takes root";
  }
  const std::string error = ErrorOf([&] { WriteFileAtomically(file_, "too much"); });
  EXPECT_THAT(error, AllOf(HasSubstr(file_.string()), HasSubstr("No space left on device")));
  EXPECT_TRUE(fs::is_character_file(file_));
}

TEST_F(AtomicFileTest, LinkKeepsPointingAtTheFile) {
  WriteFileAtomically(folder_ / "target.txt", "old");
  fs::create_symlink("target.txt", file_);
  WriteFileAtomically(file_, "new");
  EXPECT_TRUE(fs::is_symlink(file_));
  EXPECT_EQ(Read(folder_ / "target.txt"), "new");
}

TEST_F(AtomicFileTest, FolderInTheWayIsNamed) {
  WriteFileAtomically(folder_ / "plain", "a file");
  EXPECT_THAT(ErrorOf([&] { WriteFileAtomically(folder_ / "plain" / "x.txt", "x"); }),
              HasSubstr((folder_ / "plain").string() + ": cannot make the folder: "));
  EXPECT_THAT(ErrorOf([&] { WriteFileAtomically(folder_, "x"); }),
              HasSubstr(folder_.string() + ": cannot be written: "));
  EXPECT_EQ(FilesInFolder(), 1u);
}

TEST_F(AtomicFileTest, ReadersSeeOneWriterOrTheOther) {
  constexpr std::size_t kSize = 200000;
  WriteFileAtomically(file_, std::string(kSize, 'a'));
  std::atomic<int> writing{4};
  std::vector<std::thread> writers;
  for (char letter : {'a', 'b', 'c', 'd'}) {
    writers.emplace_back([&, letter] {
      for (int i = 0; i < 25; ++i) WriteFileAtomically(file_, std::string(kSize, letter));
      --writing;
    });
  }
  do {
    const std::string text = Read(file_);
    ASSERT_EQ(text.size(), kSize);
    ASSERT_EQ(text.find_first_not_of(text[0]), std::string::npos);
  } while (writing > 0);
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(FilesInFolder(), 1u);
}

TEST(IsPartOfFile, KnowsTheNamesOfFilesThatWereBegun) {
  const fs::path folder = fs::path(testing::TempDir());
  fs::path part;
  WriteFileAtomically(folder / "a.b.txt", [&](const fs::path& temporary) {
    part = temporary;
    return bool(std::ofstream(temporary) << "x");
  });
  EXPECT_TRUE(IsPartOfFile(part)) << part;
  EXPECT_FALSE(IsPartOfFile(folder / "a.b.txt"));
  for (const char* name : {"a.part-1", ".hidden", ".part-1", ".a.part-", ".a.part-x", ""}) {
    EXPECT_FALSE(IsPartOfFile(name)) << name;
  }
  fs::remove(folder / "a.b.txt");
}

}  // namespace
}  // namespace silt
