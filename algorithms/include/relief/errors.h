// Exceptions. Invalid input is reported by one exception type that names the file or option and the fault in one line.
// Programming errors assert; expected outcomes (hit, miss, step limit) are return values.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "relief/messages.h"

namespace relief {

class InputError : public std::runtime_error {
  public:
    // subject: the file, or the option ("--size"), that is at fault; may be empty.
    InputError(std::string subject, Message message)
        : std::runtime_error(subject.empty() ? sentence(message) : subject + ": " + sentence(message)),
          subject_(std::move(subject)),
          message_(std::move(message)) {}

    const std::string& subject() const { return subject_; }
    const Message& message() const { return message_; }
    // Returns the subject and the message as one line.
    std::string text(Language language) const {
        return subject_.empty() ? sentence(message_, language) : subject_ + ": " + sentence(message_, language);
    }

  private:
    std::string subject_;
    Message message_;
};

// More memory is needed than is available. Thrown before the work begins; exit status 2.
class MemoryError : public InputError {
  public:
    using InputError::InputError;
};

// The work itself failed (disk full, cancelled by the system): exit status 1, whereas InputError is 2.
class WorkError : public InputError {
  public:
    using InputError::InputError;
};

// Thrown by long work whose stop token was triggered; its partial result is discarded.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace relief
