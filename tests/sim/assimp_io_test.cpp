// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/assimp_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "sample_model.h"
#include "silt/sim/archive_io.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class AssimpIoTest : public testing::Test {
 protected:
  AssimpIoTest()
      : archive_(folder_.Write("a.zip", ZipOf({{"d/digits.txt", "0123456789"}}))),
        io_(MakeAssimpIo(archive_, missing_)) {}

  TempFolder folder_;
  Archive archive_;
  std::set<std::string> missing_;
  std::unique_ptr<Assimp::IOSystem> io_;
};

TEST_F(AssimpIoTest, ReadsAndSeeks) {
  ASSERT_TRUE(io_->Exists("d/digits.txt"));
  Assimp::IOStream* stream = io_->Open("d/digits.txt", "rb");
  ASSERT_NE(stream, nullptr);
  EXPECT_EQ(stream->FileSize(), 10u);
  char buffer[16] = {};
  EXPECT_EQ(stream->Read(buffer, 4, 2), 2u);
  EXPECT_EQ(std::string(buffer, 8), "01234567");
  EXPECT_EQ(stream->Read(buffer, 4, 2), 0u);  // two bytes are not a whole item
  EXPECT_EQ(stream->Tell(), 8u);
  EXPECT_EQ(stream->Seek(2, aiOrigin_SET), aiReturn_SUCCESS);
  EXPECT_EQ(stream->Seek(1, aiOrigin_CUR), aiReturn_SUCCESS);
  EXPECT_EQ(stream->Tell(), 3u);
  EXPECT_EQ(stream->Seek(4, aiOrigin_END), aiReturn_SUCCESS);
  EXPECT_EQ(stream->Read(buffer, 1, 16), 4u);
  EXPECT_EQ(std::string(buffer, 4), "6789");
  EXPECT_EQ(stream->Seek(11, aiOrigin_SET), aiReturn_FAILURE);
  EXPECT_EQ(stream->Seek(11, aiOrigin_END), aiReturn_FAILURE);
  EXPECT_EQ(stream->Seek(1, aiOrigin_CUR), aiReturn_FAILURE);
  EXPECT_EQ(stream->Tell(), 10u);
  EXPECT_EQ(stream->Read(buffer, 0, 3), 0u);
  EXPECT_EQ(stream->Write(buffer, 1, 3), 0u);
  io_->Close(stream);
  EXPECT_THAT(missing_, IsEmpty());
}

TEST_F(AssimpIoTest, RemembersWhatIsMissing) {
  EXPECT_FALSE(io_->Exists("d/none.mtl"));
  EXPECT_EQ(io_->Open("d/none.mtl", "rb"), nullptr);
  EXPECT_THAT(missing_, Contains(HasSubstr("a.zip(d/none.mtl): no such file")));
}

TEST_F(AssimpIoTest, NeverWrites) {
  EXPECT_EQ(io_->Open("d/digits.txt", "wb"), nullptr);
  EXPECT_THAT(missing_, IsEmpty());
}

TEST_F(AssimpIoTest, RemembersWhatIsDamaged) {
  std::filesystem::remove(folder_.path() / "a.zip");
  EXPECT_EQ(io_->Open("d/digits.txt", "rb"), nullptr);
  EXPECT_EQ(missing_.size(), 1u);
}

}  // namespace
}  // namespace silt::sim
