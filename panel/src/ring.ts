// Ring: keeps the last values of a stream. When it is full, the oldest value is dropped.

export class Ring<T> {
  private readonly items: T[] = [];
  private first = 0;

  constructor(readonly capacity: number) {}

  get length(): number {
    return this.items.length;
  }

  push(item: T): void {
    if (this.items.length < this.capacity) {
      this.items.push(item);
    } else {
      this.items[this.first] = item;
      this.first = (this.first + 1) % this.capacity;
    }
  }

  // Returns the item with the number `index`, counted from the oldest item, which has number 0.
  at(index: number): T | undefined {
    if (index < 0 || index >= this.items.length) return undefined;
    return this.items[(this.first + index) % this.items.length];
  }

  last(): T | undefined {
    return this.at(this.items.length - 1);
  }

  toArray(): T[] {
    return [...this.items.slice(this.first), ...this.items.slice(0, this.first)];
  }

  clear(): void {
    this.items.length = 0;
    this.first = 0;
  }
}
