// The marked part, and the facet that was pointed at, if one was: -1 for none.
export class Selection {
  constructor(partOfFacet) {
    this.partOfFacet = partOfFacet;
    this.part = -1;
    this.facet = -1;
    this.followers = [];
  }

  follow(act) {
    this.followers.push(act);
  }

  setFacet(facet) {
    this.set(facet < 0 ? -1 : this.partOfFacet[facet], facet);
  }

  togglePart(part) {
    this.set(part === this.part ? -1 : part, -1);
  }

  clear() {
    this.set(-1, -1);
  }

  set(part, facet) {
    this.part = part;
    this.facet = facet;
    for (const act of this.followers) act();
  }
}
