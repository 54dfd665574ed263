// Files that the reader takes along.
export function saveText(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'text/csv;charset=utf-8' }));
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const cell = (text) => (/[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);

// One line a row of the sweep: its angles, the total, and sigma of each part, as doubles that read back.
export function partsCsv(data) {
  const angles = [
    'transmitter_azimuth_deg',
    'transmitter_elevation_deg',
    'receiver_azimuth_deg',
    'receiver_elevation_deg',
  ];
  const head = [...angles, 'sigma_m2', ...data.parts.map((part) => `sigma_m2 of ${part.name}`)];
  const lines = data.rows.sigma_m2.map((sigma, row) =>
    [...angles.map((angle) => data.rows[angle][row]), sigma, ...data.part_sigma_m2[row]].map(String),
  );
  return [head, ...lines].map((line) => line.map(cell).join(',')).join('\n') + '\n';
}
