//
// MoverQueue: the commands that wait until JointMover is ready for them, oldest first.
//

#ifndef MoverQueue_h_DEFINED
#define MoverQueue_h_DEFINED

#include "Messages.h"

class MoverQueue {
public:
    MoverQueue() : first_(0), size_(0) {}

    // Appends a command.  Returns false and changes nothing when the queue is full.
    bool Push(const MoverCommand& command)
    {
        if (size_ == CAPACITY) return false;
        command_[(first_ + size_) % CAPACITY] = command;
        size_++;
        return true;
    }

    bool IsEmpty() const { return size_ == 0; }

    // Removes the oldest command from the queue and returns it.  REQUIRES: !IsEmpty().
    MoverCommand Pop()
    {
        const int index = first_;
        first_ = (first_ + 1) % CAPACITY;
        size_--;
        return command_[index];
    }

private:
    // Maximum number of commands in the queue: enough if six clients command all joints (at most
    // 20) before JointMover is ready again.
    static const int CAPACITY = 128;

    MoverCommand command_[CAPACITY];
    int first_;
    int size_;
};

#endif  // MoverQueue_h_DEFINED
