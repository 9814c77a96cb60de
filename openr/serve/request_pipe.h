// RequestPipe: requests and answers between a served run and the program that drives it.
//
// Both directions have the same form.  First come two little-endian numbers of 4 bytes: the length
// of a JSON text and the number of further bytes.  Then come the text and the bytes.  The bytes
// hold values of type double in the byte order of the computer, pictures or data of messages, which
// would be slow or long as JSON.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

namespace openr_host {

class RequestPipe {
 public:
  // The largest number of bytes that a request may have; no program needs nearly as many.
  static constexpr size_t kRequestMax = size_t{64} << 20;

  // Reads requests from `input` and writes answers to `output`.  Both may be the same socket.
  // Does not close the descriptors.
  RequestPipe(int input, int output);
  ~RequestPipe();
  RequestPipe(const RequestPipe&) = delete;
  RequestPipe& operator=(const RequestPipe&) = delete;

  // Waits for a request.  Returns false if the other end of the pipe is closed.  Throws
  // RequestTooLong if the request is longer than kRequestMax.
  bool Receive(std::string* text, std::string* bytes);

  // Sends the answer to a request: `text`, and after it `bytes`.  Returns false if the other end of
  // the pipe is closed.  May be called in a signal handler that ends the process.
  bool Send(std::string_view text, std::string_view bytes);

  // Returns the descriptor that came with the last request; -1 if no descriptor came.  The caller
  // owns the descriptor.
  int TakeDescriptor();

  // Closes the file descriptors that came with requests and that no command has used.  Keeps them
  // if a part of the next request has come already, because they may belong to that request.
  void DropDescriptors();

  // Returns whether a descriptor can come with a request.  This is possible if the input is a Unix
  // socket.
  bool is_socket() const { return is_socket_; }

  // Goes on with the socket `socket` instead of the old input and output.  Called in a fork of the
  // process.  Drops bytes that were received but not used yet.
  void UseSocket(int socket);

 private:
  bool Fill(size_t wanted);
  long ReadSome(char* bytes, size_t size);

  int input_;
  int output_;
  bool is_socket_;
  std::string buffer_;
  size_t used_ = 0;  // bytes at the beginning of `buffer_` that Receive() has already returned
  size_t end_ = 0;   // number of bytes in `buffer_`
  std::deque<int> descriptors_;
};

}  // namespace openr_host
