const MOST_PIXELS = 4096 * 2160;
const MOST_WAITING = 30;  // frames in the decoder's queue; if more wait, all are dropped and a key frame is requested
const KEY_HEADER_BYTES = 10;
const CONFIG = {codec: 'vp8', optimizeForLatency: true};

/** Whether this browser decodes VP8. */
export async function decodesVideo(): Promise<boolean> {
  if (typeof VideoDecoder === 'undefined') return false;
  try {
    return (await VideoDecoder.isConfigSupported(CONFIG)).supported === true;
  } catch {
    return false;
  }
}

/** True for a VP8 key frame (RFC 6386, section 9.1). */
const isKeyFrame = (frame: Uint8Array) => frame.length >= KEY_HEADER_BYTES && (frame[0]! & 1) === 0;

/** True if the size in a key frame's header is allowed. The decoder allocates memory by it, so it is checked first. */
function hasAllowedSize(key: Uint8Array): boolean {
  const side = (at: number) => (key[at]! | key[at + 1]! << 8) & 0x3fff;
  const pixels = side(6) * side(8);
  return pixels > 0 && pixels <= MOST_PIXELS;
}

/** Decodes colour that comes as video, with the browser's decoder. A frame whose reference is missing is not decoded. */
export class ColorVideo {
  undecodable = 0;
  private decoder: VideoDecoder | undefined;  // undefined: the next frame must be a key frame
  private readonly captured = new Map<number, bigint>();  // capture times, by the frame's time stamp [us], which is all that the decoder returns

  constructor(private readonly on: {
    picture: (picture: ImageBitmap, captured_ns: bigint) => void;
    needsKeyFrame: () => void;
  }) {}

  came(frame: Uint8Array, captured_ns: bigint): void {
    const key = isKeyFrame(frame);
    if (key && !hasAllowedSize(frame)) return this.failed();
    if (!key && this.decoder === undefined) return this.on.needsKeyFrame();
    if (this.decoder !== undefined && this.decoder.decodeQueueSize > MOST_WAITING) return this.failed();
    this.decoder ??= this.begun();
    const timestamp = Number(captured_ns / 1000n);
    this.captured.set(timestamp, captured_ns);
    try {
      this.decoder.decode(new EncodedVideoChunk({type: key ? 'key' : 'delta', timestamp, data: frame}));
    } catch {
      this.failed();
    }
  }

  /** A new connection begins: its first frame is a key frame. */
  restart(): void {
    if (this.decoder !== undefined && this.decoder.state !== 'closed') this.decoder.close();
    this.decoder = undefined;
    this.captured.clear();
  }

  private begun(): VideoDecoder {
    const decoder = new VideoDecoder({
      output: (frame) => void this.show(frame),
      error: () => {
        if (this.decoder === decoder) this.failed();
      },
    });
    decoder.configure(CONFIG);
    return decoder;
  }

  private failed(): void {
    ++this.undecodable;
    this.restart();
    this.on.needsKeyFrame();
  }

  private async show(frame: VideoFrame): Promise<void> {
    const captured_ns = this.captured.get(frame.timestamp);
    for (const timestamp of this.captured.keys()) if (timestamp <= frame.timestamp) this.captured.delete(timestamp);
    try {
      const picture = await createImageBitmap(frame);
      if (captured_ns === undefined) picture.close();
      else this.on.picture(picture, captured_ns);
    } finally {
      frame.close();
    }
  }
}
