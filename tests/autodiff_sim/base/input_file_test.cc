// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/input_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::EndsWith;
using testing::HasSubstr;

class InputFile : public testing::Test {
 protected:
  InputFile() {
    std::string name = (fs::temp_directory_path() / "clothfit-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::ofstream(folder_ / "file") << "text";
  }
  ~InputFile() override { fs::remove_all(folder_); }

  std::string ErrorOf(const std::string& name, std::size_t most = kMostBytes) const {
    try {
      ReadInputFile(folder_ / name, most);
      CheckInputFile(folder_ / name, most);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(InputFile, IsReadWhole) {
  EXPECT_EQ(ReadInputFile(folder_ / "file"), "text");
  fs::create_symlink("file", folder_ / "link");
  EXPECT_EQ(ReadInputFile(folder_ / "link"), "text");
  EXPECT_TRUE(IsThere(folder_ / "link"));
  EXPECT_FALSE(IsThere(folder_ / "none"));
  EXPECT_FALSE(IsThere(folder_ / "file" / "none"));
}

TEST_F(InputFile, SaysWhyItIsRefused) {
  EXPECT_THAT(ErrorOf("none"), EndsWith("none: no such file"));
  EXPECT_THAT(ErrorOf("file", 3), EndsWith("file: has 4 bytes; expected at most 3"));
  EXPECT_THAT(ErrorOf("."), HasSubstr("is a folder; expected a file"));
  fs::create_symlink("/dev/zero", folder_ / "zero");
  EXPECT_THAT(ErrorOf("zero"), EndsWith("zero: is a device; expected a file"));
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THAT(ErrorOf("loop"), HasSubstr("loop: cannot be read: Too many levels"));
  EXPECT_THROW(IsThere(folder_ / "loop"), InputError);
  EXPECT_THAT(ErrorOf(std::string(300, 'x')), HasSubstr("cannot be read: File name too long"));
}

TEST_F(InputFile, IsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(ErrorOf("pipe"), EndsWith("pipe: is a pipe; expected a file"));
  const int socket_file = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  (folder_ / "socket").string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(bind(socket_file, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_THAT(ErrorOf("socket"), HasSubstr("socket: is a socket or a device; expected a file"));
  close(socket_file);
}

TEST_F(InputFile, ListsFoldersInOrder) {
  std::ofstream(folder_ / "a") << "";
  std::ofstream(folder_ / ".hidden") << "";
  EXPECT_THAT(ListInputFolder(folder_), testing::ElementsAre(folder_ / "a", folder_ / "file"));
  EXPECT_THROW(ListInputFolder(folder_ / "file"), InputError);
  EXPECT_THROW(ListInputFolder(folder_ / "none"), InputError);
}

}  // namespace
}  // namespace clothfit
