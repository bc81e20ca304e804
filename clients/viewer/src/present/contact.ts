import {Phase} from '../messages/generated';

const IN_CONTACT: ReadonlySet<Phase> =
    new Set([Phase.IN_BODY, Phase.CYLINDER_LATERAL, Phase.AROUND_CYLINDER, Phase.CYLINDER_UPPER]);

/**
 * True where the skin, or an object below it, gives the device's force. Elsewhere the force is the drive's, which moves
 * the free device. `indexing`: the device is beyond the cylinder of workspace indexing.
 */
export const isContact = (phase: Phase | undefined, indexing = false) =>
    phase !== undefined && IN_CONTACT.has(phase) && !indexing;
