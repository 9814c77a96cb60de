// Touch: tells whether a control may show the value of the run. It may not while a person changes
// the control, and not until the run has answered the last change: values that the run has sent
// before would move the control back.
export class Touch {
  private touches = 0;
  private answered = 0; // the number of touches when the last answered change was made

  // To be called when a person moves the control.
  begin(): void {
    this.touches += 1;
  }

  // To be called when a change is sent to the run. Returns the function to call when the run has
  // answered this change.
  change(): () => void {
    const touch = this.touches;
    return () => {
      this.answered = touch;
    };
  }

  isOver(): boolean {
    return this.answered === this.touches;
  }
}
